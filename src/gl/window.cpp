// A GLFW window that is never shown: the way to a context where neither EGL nor OSMesa exists.
#include "gl/backend.hpp"

#include "core/error.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace sr::gl {
namespace {

std::string glfw_failure() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "unknown reason";
}

class WindowContext final : public Context {
public:
    explicit WindowContext(bool debug) {
        if (!glfwInit())
            throw Error(fmt::format("window: {}", glfw_failure()),
                        "set DISPLAY, or use --backend egl or osmesa");
        glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // macOS offers no other core profile
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug ? GLFW_TRUE : GLFW_FALSE);
        window_ = glfwCreateWindow(16, 16, "Steradian", nullptr, nullptr);
        if (!window_) {
            const std::string failure = glfw_failure();
            glfwTerminate();
            throw Error(fmt::format("window: {}", failure),
                        "update the driver, or use --backend egl or osmesa");
        }
        glfwMakeContextCurrent(window_);
        try {
            loaded("window", glfwGetProcAddress, debug);
        } catch (...) {
            close();
            throw;
        }
    }
    ~WindowContext() override {
        debug_.reset();
        close();
    }

private:
    void close() {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }

    GLFWwindow* window_ = nullptr;
};

} // namespace

std::unique_ptr<Context> open_window(bool debug) { return std::make_unique<WindowContext>(debug); }

} // namespace sr::gl
