#pragma once
// An OpenGL context in a GLFW window, shown or not.
#include "gl/context.hpp"

struct GLFWwindow;

namespace sr::gl {

struct WindowOptions {
    std::string title = "Steradian";
    int width = 16; // of what is drawn into [pixels]
    int height = 16;
    bool is_visible = false;
    bool is_fullscreen = false; // on the primary monitor, in its own size
    bool debug = false;
};

/// One at a time, on the main thread, as GLFW wants it.
class Window final : public Context {
public:
    /// @throws Error without a display, or if the driver offers less than OpenGL 4.1 core.
    explicit Window(const WindowOptions& options);
    ~Window() override;

    GLFWwindow* handle() const { return window_; }

private:
    void close();

    GLFWwindow* window_ = nullptr;
};

/// Calls `end` when the connection to the X server is lost, instead of Xlib's own two lines, on whatever
/// thread notices it. Xlib ends the program once `end` returns, so it must not return, and must not touch the
/// window. Without X11 nothing happens.
void when_display_is_lost(void (*end)());

} // namespace sr::gl
