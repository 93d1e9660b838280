#pragma once
// Interface of a tool of the viewer: handles events, draws, and returns what it changed.
#include "viewer/workspace.hpp"

#include <functional>
#include <memory>

namespace sr::viewer {

/// The context that panels and overlays are drawn with.
struct Overlay {
    Projection projection;
    float scale = 1.0f;                    // of a HiDPI screen
    std::function<bool(vec3 point)> hides; // true if a surface in the picture lies before the point
};

/// The rate at which a tool needs update() while there are no events.
enum class Activity {
    idle,      // now and then
    waiting,   // often: it waits for work on another thread
    active,    // every frame
    exclusive, // every frame, while the render waits
};

/// The App calls tools once the first scene is shown. A new tool is a class, a line in make_tools() and, if
/// it has keys, lines in bindings.
class Tool {
public:
    explicit Tool(Workspace& workspace) : ws_(workspace) {}
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    /// Handles an event. An event goes to one tool after the other until one handles it; MotionEvents and
    /// Command::cancel go to all. @return what changed; absent if the tool does not handle the event
    virtual std::optional<Changes> handle(const Event& /*event*/) { return std::nullopt; }
    /// Advances by `seconds`, at least five times a second.
    virtual Changes update(double /*seconds*/) { return {}; }
    /// Is told what any tool changed.
    virtual void notice(Changes /*changes*/) {}

    /// Draws over the picture: handles, marks, windows of its own.
    virtual Changes draw(const Overlay& /*overlay*/) { return {}; }
    /// Draws a section of the main panel.
    virtual Changes draw_section() { return {}; }

    /// A film to show instead of the render; none by default.
    virtual FilmSum film() const { return {}; }
    /// A film to compare the render with; none by default.
    virtual FilmSum reference_film() const { return {}; }
    /// True during a drag, in which events belong to the tool even over a panel.
    virtual bool holds_pointer() const { return false; }
    /// True while a dialog of the tool is open: keys are typed, and no commands.
    virtual bool holds_keyboard() const { return false; }
    virtual Activity activity() const { return Activity::idle; }

protected:
    Workspace& ws_;
};

/// The command of an event; absent if the event is another one.
inline std::optional<Command> command_in(const Event& event) {
    const auto* command = std::get_if<CommandEvent>(&event);
    return command ? std::optional(command->command) : std::nullopt;
}

/// The tools, each a class in the file of its name.
std::unique_ptr<Tool> make_tick(Workspace& workspace); // null without Options::is_examined
std::unique_ptr<Tool> make_transform(Workspace& workspace);
std::unique_ptr<Tool> make_navigate(Workspace& workspace);
std::unique_ptr<Tool> make_adjust_display(Workspace& workspace);
std::unique_ptr<Tool> make_animate(Workspace& workspace);
std::unique_ptr<Tool> make_assignment(Workspace& workspace); // null without an assignment
std::unique_ptr<Tool> make_compare(Workspace& workspace);
std::unique_ptr<Tool> make_copy_picture(Workspace& workspace);
std::unique_ptr<Tool> make_edit_lights(Workspace& workspace);
std::unique_ptr<Tool> make_explain(Workspace& workspace);
std::unique_ptr<Tool> make_export_picture(Workspace& workspace);
std::unique_ptr<Tool> make_files(Workspace& workspace);
std::unique_ptr<Tool> make_inspect(Workspace& workspace);
std::unique_ptr<Tool> make_keep_edits(Workspace& workspace);
std::unique_ptr<Tool> make_look_at_pixels(Workspace& workspace);
std::unique_ptr<Tool> make_measure_illuminance(Workspace& workspace);
std::unique_ptr<Tool> make_mix_lights(Workspace& workspace);
std::unique_ptr<Tool> make_place_camera(Workspace& workspace);
std::unique_ptr<Tool> make_probe(Workspace& workspace);
std::unique_ptr<Tool> make_revisit_views(Workspace& workspace);
std::unique_ptr<Tool> make_show_grid(Workspace& workspace);
std::unique_ptr<Tool> make_show_times(Workspace& workspace);
std::unique_ptr<Tool> make_turntable(Workspace& workspace);
std::unique_ptr<Tool> make_view_light(Workspace& workspace);

} // namespace sr::viewer
