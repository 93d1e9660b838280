#include "gl/context.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"

#include <array>
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
    const char* const what_to_do = "this is a bug in Steradian or in the driver, please report it";
    const auto& messages = debug_messages();
    const GLenum error = glGetError(); // all that a context without debug output tells
    if (messages.empty() && error != GL_NO_ERROR)
        throw Error(fmt::format("OpenGL reports the error {:#06x}", error), what_to_do);
    if (messages.empty()) return;
    throw Error(fmt::format("OpenGL says ({} message{}): {}", messages.size(),
                            messages.size() == 1 ? "" : "s", messages.front()),
                what_to_do);
}

namespace {

struct Entry {
    Backend backend;
    const char* name;
    std::unique_ptr<Context> (*open)(bool debug);
};

/// In the order in which `auto` tries them.
constexpr std::array<Entry, 3> entries{{
    {Backend::egl, "egl", open_egl},
    {Backend::osmesa, "osmesa", open_osmesa},
    {Backend::window, "window", open_window},
}};

} // namespace

std::optional<Backend> backend_named(std::string_view name) {
    if (name == "auto") return Backend::automatic;
    for (const Entry& entry : entries)
        if (name == entry.name) return entry.backend;
    return std::nullopt;
}

const char* name_of(Backend backend) {
    for (const Entry& entry : entries)
        if (entry.backend == backend) return entry.name;
    return "auto";
}

std::unique_ptr<Context> open_context(const ContextOptions& options) {
    require_threads();
    std::string failures;
    for (const Entry& entry : entries) {
        if (options.backend == entry.backend) return entry.open(options.debug);
        if (options.backend != Backend::automatic) continue;
        try {
            return entry.open(options.debug);
        } catch (const Error& error) {
            failures += fmt::format("{}{}", failures.empty() ? "" : "; ", error.what());
        }
    }
    throw Error(fmt::format("no OpenGL 4.1 here ({})", failures),
                "install a driver, e.g. sudo apt-get install libegl1 libgl1-mesa-dri");
}

std::vector<BackendReport> report_backends() {
    std::vector<BackendReport> reports;
    for (const Entry& entry : entries) {
        try {
            reports.push_back({entry.name, entry.open(false)->info(), ""});
        } catch (const Error& error) {
            reports.push_back({entry.name, std::nullopt, error.what()});
        }
    }
    return reports;
}

namespace {

constexpr std::size_t max_messages = 100; // a failing call in a loop must not eat the memory

void GLAD_API_PTR collect(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length,
                          const GLchar* text, const void* log) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE) return;
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER)
        return; // Program tells that better, with the file and line
    auto& messages = *static_cast<std::vector<std::string>*>(const_cast<void*>(log));
    if (messages.size() < max_messages) messages.emplace_back(text, static_cast<std::size_t>(length));
}

} // namespace

DebugLog::DebugLog() {
    if (!GLAD_GL_KHR_debug) return;
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(collect, &messages_);
}

DebugLog::~DebugLog() {
    if (GLAD_GL_KHR_debug) glDebugMessageCallback(nullptr, nullptr);
}

} // namespace sr::gl
