#include "gl/context.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <glad/gl.h>

namespace sr::gl {
namespace {

std::string driver_string(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

} // namespace

bool is_software_renderer(std::string_view renderer) {
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"})
        if (renderer.find(name) != std::string_view::npos) return true;
    return false;
}

bool ContextInfo::is_software() const { return is_software_renderer(renderer); }

void Context::loaded(std::string backend, void (*(*load)(const char*))(), bool debug) {
    const int version = gladLoadGL(load);
    if (version < GLAD_MAKE_VERSION(4, 1))
        throw Error(fmt::format("{}: OpenGL {}.{} only", backend, GLAD_VERSION_MAJOR(version),
                                GLAD_VERSION_MINOR(version)),
                    "Steradian needs 4.1 core; update the driver");
    info_ = {std::move(backend), driver_string(GL_RENDERER), driver_string(GL_VERSION),
             driver_string(GL_SHADING_LANGUAGE_VERSION)};
    if (debug) debug_ = std::make_unique<DebugLog>();
}

const std::vector<std::string>& Context::debug_messages() const {
    static const std::vector<std::string> none;
    return debug_ ? debug_->messages() : none;
}

void Context::require_silence() const {
    const auto& messages = debug_messages();
    if (messages.empty()) return;
    throw Error(fmt::format("OpenGL says ({} message{}): {}", messages.size(),
                            messages.size() == 1 ? "" : "s", messages.front()),
                "this is a bug in Steradian or in the driver, please report it");
}

} // namespace sr::gl
