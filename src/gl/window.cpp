// Never shown, it is the way to a context where neither EGL nor OSMesa exists.
#include "gl/window.hpp"

#include "core/error.hpp"
#include "gl/context.hpp"
#include "gl/shared_library.hpp"

#include <GLFW/glfw3.h>
#include <atomic>
#include <cstdlib>
#include <fmt/format.h>

#define GLFW_INCLUDE_NONE

namespace sr::gl {
namespace {

std::string glfw_failure() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "unknown reason";
}

/// GLFW 3.4 tries Wayland first where no session says what it is, and libwayland then writes an error to
/// stderr.
void choose_platform() {
#ifdef GLFW_PLATFORM_X11
    if (!std::getenv("WAYLAND_DISPLAY") && !std::getenv("WAYLAND_SOCKET")
        && glfwPlatformSupported(GLFW_PLATFORM_X11))
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
}

void hint(const WindowOptions& options) {
    glfwWindowHint(GLFW_VISIBLE, options.is_visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // macOS offers no other core profile
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
    // The picture goes from the Film to the window pixel by pixel: it needs no depth of the window's own.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

GLFWwindow* open(const WindowOptions& options) {
    if (!options.is_fullscreen)
        return glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    return glfwCreateWindow(mode ? mode->width : options.width, mode ? mode->height : options.height,
                            options.title.c_str(), monitor, nullptr);
}

} // namespace

Window::Window(const WindowOptions& options) {
    choose_platform();
    if (!glfwInit())
        throw Error(fmt::format("window: {}", glfw_failure()),
                    options.is_visible ? "set DISPLAY to a display that can be reached, or render without a "
                                         "window: steradian render"
                                       : "set DISPLAY, or use --backend egl or osmesa");
    hint(options);
    window_ = open(options);
    if (!window_) {
        const std::string failure = glfw_failure();
        glfwTerminate();
        throw Error(fmt::format("window: {}", failure),
                    options.is_visible ? "update the driver, or render without a window: steradian render"
                                       : "update the driver, or use --backend egl or osmesa");
    }
    glfwMakeContextCurrent(window_);
    try {
        loaded("window", glfwGetProcAddress, options.debug);
    } catch (...) {
        close();
        throw;
    }
}

Window::~Window() {
    debug_.reset();
    close();
}

void Window::close() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

std::unique_ptr<Context> open_window(bool debug) {
    WindowOptions options;
    options.debug = debug;
    return std::make_unique<Window>(options);
}

namespace {

std::atomic<void (*)()> end_of_display{nullptr}; // Xlib hands nothing of ours to its handler

int lost(void* /*display*/) {
    if (const auto end = end_of_display.load()) end();
    return 0;
}

} // namespace

void when_display_is_lost(void (*end)()) {
    end_of_display = end;
    using Handler = int(void*);
    const auto xlib = SharedLibrary::open({"libX11.so.6"}); // the very one that GLFW has opened
    if (!xlib) return;
    if (auto* set_handler = xlib->function<Handler*(Handler*)>("XSetIOErrorHandler")) set_handler(lost);
}

} // namespace sr::gl
