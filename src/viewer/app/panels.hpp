#pragma once
// Panels of the window: the column of sections, the message area, help, history, questions, errors.
#include "viewer/panels/command_palette.hpp"
#include "viewer/panels/first_page.hpp"
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

using Tools = std::vector<std::unique_ptr<Tool>>;

class Panels {
public:
    /// They are shown, and as wide, as they were when a window was last closed.
    explicit Panels(Workspace& workspace);

    /// Looks after what is made beside the window, some times a second.
    Changes update();
    /// Begins a frame: gives the picture the room that panels leave.
    void begin();
    /// Describes all panels between Ui::begin() and Ui::end(), and the areas that they take. @return what
    /// they changed
    Changes draw(const Tools& tools);

    /// Executes a command that shows or hides a panel. @return false if the command is another
    bool execute(Command command);
    /// Closes the innermost of what is over the picture. @return false if nothing is
    bool close_one();
    /// True while keys are typed into the palette.
    bool holds_keyboard() const { return palette_.is_open() || has_first_page(); }
    /// True if this key runs a command of the palette.
    bool runs_command(int key) const;
    /// Takes the keys that go through the rows of the palette. @return false for any other
    bool take(const KeyEvent& key);

private:
    bool has_first_page() const { return !ws_.scene && ws_.has_first_page && !ws_.loading; }
    Changes draw_first_page();
    void toggle();
    void show();
    void draw_over_picture();
    void draw_menu();
    void draw_views_menu();
    void draw_lights_menu();
    void draw_tabs();
    Changes draw_column(const Tools& tools);
    std::string under_pointer() const;

    Workspace& ws_;
    bool are_shown_ = true;
    CommandPalette palette_;
    FirstPage first_page_;
    std::string shown_tab_; // of those that share a column
    bool has_help_ = false;
    bool has_history_ = false; // of messages
};

} // namespace sr::viewer
