#pragma once
// Dear ImGui on a window, for as long as this lives.
#include <string>
#include <vector>

struct GLFWwindow;

namespace sr::viewer {

class Ui {
public:
    /// Remembers where panels are in $XDG_CONFIG_HOME/steradian/panels.ini (or ~/.config).
    explicit Ui(GLFWwindow* window);
    ~Ui();
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    /// Between the two, panels are described.
    void begin();
    void end();

    /// Whether the pointer is on a panel, and whether a text field has the keyboard.
    bool has_pointer() const;
    bool has_keyboard() const;
    bool has_active_item() const; // a field or a button is in use

    /// A key (as GLFW numbers them) went down since the last frame: the next one hears of it even if it is up
    /// again, which happens where frames are slow.
    void press(int key);
    float scale() const { return scale_; } // of a HiDPI screen

private:
    void watch_scale();
    void release_keys();

    GLFWwindow* window_;
    float scale_ = 0.0f;
    std::string layout_file_;
    std::vector<int> pressed_;
};

} // namespace sr::viewer
