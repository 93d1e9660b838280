// OSMesa: Mesa's renderer into plain memory, found with dlopen because new Mesa versions no longer ship it.
#include "gl/context.hpp"

#include "core/error.hpp"
#include "gl/shared_library.hpp"

#include <array>
#include <cstdint>
#include <glad/gl.h>

namespace sr::gl {
namespace {

// The few names of GL/osmesa.h (Mesa 12 and later) that are needed, so that its headers are not.
constexpr int osmesa_format = 0x22;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_context_major_version = 0x36;
constexpr int osmesa_context_minor_version = 0x37;
using OsmesaContextHandle = void*;
using OsmesaProc = void (*)();

struct Osmesa {
    OsmesaContextHandle (*create_context)(const int* attributes, OsmesaContextHandle share);
    void (*destroy_context)(OsmesaContextHandle);
    GLboolean (*make_current)(OsmesaContextHandle, void* buffer, GLenum type, GLsizei width, GLsizei height);
    OsmesaProc (*get_proc_address)(const char* name);
};

Osmesa load_osmesa() {
    const auto library = SharedLibrary::open({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
    if (!library)
        throw Error("OSMesa: libOSMesa.so.8 is not installed",
                    "sudo apt-get install libosmesa6 (Mesa 25.1 and later no longer have it: use EGL)");
    Osmesa osmesa{};
    const auto load = [&](auto& function, const char* name) {
        function =
            library->function<std::remove_pointer_t<std::remove_reference_t<decltype(function)>>>(name);
        if (!function) throw Error("OSMesa: the library is too old", "install Mesa 12 or later");
    };
    load(osmesa.create_context, "OSMesaCreateContextAttribs");
    load(osmesa.destroy_context, "OSMesaDestroyContext");
    load(osmesa.make_current, "OSMesaMakeCurrent");
    load(osmesa.get_proc_address, "OSMesaGetProcAddress");
    return osmesa;
}

class OsmesaContext final : public Context {
public:
    explicit OsmesaContext(bool debug) : osmesa_(load_osmesa()) {
        const std::array<int, 11> attributes{osmesa_format,
                                             GL_RGBA,
                                             osmesa_depth_bits,
                                             24,
                                             osmesa_profile,
                                             osmesa_core_profile,
                                             osmesa_context_major_version,
                                             4,
                                             osmesa_context_minor_version,
                                             1,
                                             0};
        context_ = osmesa_.create_context(attributes.data(), nullptr);
        if (!context_) throw Error("OSMesa: no OpenGL 4.1 core context", "update libosmesa6");
        // OSMesa insists on a default framebuffer; ours are all objects of our own, so one pixel does.
        if (!osmesa_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
            osmesa_.destroy_context(context_);
            throw Error("OSMesa: the context cannot be made current", "update libosmesa6");
        }
        loaded("OSMesa", osmesa_.get_proc_address, debug);
    }
    ~OsmesaContext() override {
        debug_.reset();
        osmesa_.make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        osmesa_.destroy_context(context_);
    }

private:
    Osmesa osmesa_;
    OsmesaContextHandle context_ = nullptr;
    std::array<std::uint8_t, 4> buffer_{};
};

} // namespace

std::unique_ptr<Context> open_osmesa(bool debug) { return std::make_unique<OsmesaContext>(debug); }

} // namespace sr::gl
