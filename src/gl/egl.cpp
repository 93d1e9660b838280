// EGL without a window system: Mesa's surfaceless platform first, then EGL devices (the way to a GPU on a
// server).
#include "gl/context.hpp"

#include "core/error.hpp"
#include "gl/shared_library.hpp"

#ifdef STERADIAN_HAS_EGL
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <glad/gl.h>
#include <vector>

namespace sr::gl {
namespace {

/// The EGL functions in use, found at run time.
struct Egl {
    decltype(&eglGetProcAddress) get_proc_address;
    decltype(&eglInitialize) initialize;
    decltype(&eglBindAPI) bind_api;
    decltype(&eglChooseConfig) choose_config;
    decltype(&eglCreateContext) create_context;
    decltype(&eglDestroyContext) destroy_context;
    decltype(&eglMakeCurrent) make_current;
    decltype(&eglQueryString) query_string;
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display;
    PFNEGLQUERYDEVICESEXTPROC query_devices;            // may be null
    PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string; // may be null
};

Egl load_egl() {
    const auto library = SharedLibrary::open({"libEGL.so.1", "libEGL.so"});
    if (!library)
        throw Error("EGL: libEGL.so.1 is not installed", "sudo apt-get install libegl1 libgl1-mesa-dri");
    Egl egl{};
    egl.get_proc_address =
        library->function<std::remove_pointer_t<decltype(egl.get_proc_address)>>("eglGetProcAddress");
    if (!egl.get_proc_address) throw Error("EGL: the library has no eglGetProcAddress", "reinstall libegl1");
    const auto load = [&](auto& function, const char* name) {
        function =
            library->function<std::remove_pointer_t<std::remove_reference_t<decltype(function)>>>(name);
    };
    load(egl.initialize, "eglInitialize");
    load(egl.bind_api, "eglBindAPI");
    load(egl.choose_config, "eglChooseConfig");
    load(egl.create_context, "eglCreateContext");
    load(egl.destroy_context, "eglDestroyContext");
    load(egl.make_current, "eglMakeCurrent");
    load(egl.query_string, "eglQueryString");
    const auto extension = [&](auto& function, const char* name) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(egl.get_proc_address(name));
    };
    extension(egl.get_platform_display, "eglGetPlatformDisplayEXT");
    extension(egl.query_devices, "eglQueryDevicesEXT");
    extension(egl.query_device_string, "eglQueryDeviceStringEXT");
    if (!egl.get_platform_display) throw Error("EGL: no platform displays", "install a newer libegl1");
    return egl;
}

bool lists(const char* extensions, const char* name) {
    return extensions && std::strstr(extensions, name) != nullptr;
}

class EglContext final : public Context {
public:
    EglContext(const Egl& egl, EGLDisplay display, const char* backend, bool debug)
        : egl_(egl), display_(display) {
        if (display_ == EGL_NO_DISPLAY || !egl_.initialize(display_, nullptr, nullptr))
            throw Error(fmt::format("{}: no display", backend), "install its driver, e.g. libegl-mesa0");
        try {
            create(backend, debug);
        } catch (...) {
            close();
            throw;
        }
    }
    ~EglContext() override {
        debug_.reset();
        close();
    }

private:
    void create(const char* backend, bool debug) {
        if (!lists(egl_.query_string(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
            throw Error(fmt::format("{}: no surfaceless contexts", backend), "update the driver");
        const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                           EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        egl_.bind_api(EGL_OPENGL_API);
        if (!egl_.choose_config(display_, wanted.data(), &config, 1, &count) || count == 0)
            throw Error(fmt::format("{}: no configuration for OpenGL", backend),
                        "install a desktop OpenGL driver");
        const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                               4,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               1,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_CONTEXT_OPENGL_DEBUG,
                                               debug ? EGL_TRUE : EGL_FALSE,
                                               EGL_NONE};
        context_ = egl_.create_context(display_, config, EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT)
            throw Error(fmt::format("{}: no OpenGL 4.1 core context", backend), "update the driver");
        if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
            throw Error(fmt::format("{}: the context cannot be made current", backend), "update the driver");
        loaded(backend, egl_.get_proc_address, debug);
    }

    // The display is not terminated: it is the process's, and shared by all contexts on it.
    void close() {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) egl_.destroy_context(display_, context_);
    }

    Egl egl_;
    EGLDisplay display_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

std::unique_ptr<Context> open_surfaceless(const Egl& egl, bool debug) {
    if (!lists(egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
        throw Error("EGL surfaceless: not offered", "install libegl-mesa0");
    return std::make_unique<EglContext>(
        egl, egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr), "EGL surfaceless",
        debug);
}

/// The devices that are GPUs, or those that are software.
std::vector<EGLDeviceEXT> devices_of(const Egl& egl, bool is_software) {
    std::array<EGLDeviceEXT, 16> all{};
    EGLint count = 0;
    if (egl.query_devices) egl.query_devices(static_cast<EGLint>(all.size()), all.data(), &count);
    std::vector<EGLDeviceEXT> devices;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDeviceEXT device = all[static_cast<std::size_t>(i)];
        const char* extensions =
            egl.query_device_string ? egl.query_device_string(device, EGL_EXTENSIONS) : nullptr;
        if (lists(extensions, "EGL_MESA_device_software") == is_software) devices.push_back(device);
    }
    return devices;
}

/// The first of the devices that works; null if none does.
std::unique_ptr<Context> open_device(const Egl& egl, const std::vector<EGLDeviceEXT>& devices, bool debug) {
    for (const EGLDeviceEXT device : devices) {
        try {
            return std::make_unique<EglContext>(
                egl, egl.get_platform_display(EGL_PLATFORM_DEVICE_EXT, device, nullptr), "EGL device", debug);
        } catch (const Error&) { // the next device may do
        }
    }
    return nullptr;
}

} // namespace

std::unique_ptr<Context> open_egl(bool debug) {
    const Egl egl = load_egl();
    const auto gpus = devices_of(egl, false);
    std::string failure;
    try {
        auto surfaceless = open_surfaceless(egl, debug);
        if (!surfaceless->info().is_software() || gpus.empty()) return surfaceless;
    } catch (const Error& error) {
        failure = error.what();
    }
    // Surfaceless is Mesa's alone: a GPU with another driver is found among the devices.
    if (auto context = open_device(egl, gpus, debug)) return context;
    if (failure.empty()) return open_surfaceless(egl, debug);
    if (auto context = open_device(egl, devices_of(egl, true), debug)) return context;
    throw Error(fmt::format("{}; no EGL device works", failure), "check that this user may open /dev/dri/*");
}

} // namespace sr::gl
#else
namespace sr::gl {
std::unique_ptr<Context> open_egl(bool) {
    throw Error("EGL: not built in", "install EGL's headers and build again, or use another --backend");
}
} // namespace sr::gl
#endif
