#pragma once
// Navigation tool: orbit, pan, dolly, look around and fly with the pointer; cameras of the file.
#include "viewer/tools/tool.hpp"

#include <functional>

namespace sr::viewer {

/// Navigation by pointer events. Plain data: no window.
class Navigation {
public:
    /// With inertia, a view that is released in motion glides on for a moment.
    explicit Navigation(bool has_inertia = false) : has_inertia_(has_inertia) {}

    /// Surface at a place of the window; absent if there is none.
    using PointUnder = std::function<std::optional<vec3>(vec2)>;

    struct Effect {
        bool has_moved = false;
        std::optional<vec2> clicked; // a press and release of the left button in one place
        int modifiers = no_modifier; // that it was pressed with
    };

    /// `window`: its size, in the unit of the events.
    Effect handle(const Event& event, Viewpoint& view, vec2 window, const PointUnder& point_under);

    /// Advances a glide by `seconds`; to be called every frame. @return true if the view changed
    bool advance(double seconds, Viewpoint& view);

    bool is_gliding() const { return gliding_ != Drag::none; }
    bool is_dragging() const { return drag_ != Drag::none; }
    bool is_flying() const { return drag_ == Drag::look; }

private:
    enum class Drag { none, orbit, pan, dolly, look };
    static Drag drag_of(const ButtonEvent& press);

    static void drag(Drag how, vec2 by, Viewpoint& view);
    void press(const ButtonEvent& event);
    Effect move(vec2 to, Viewpoint& view, vec2 window);
    Effect scroll(const ScrollEvent& event, Viewpoint& view, const std::optional<vec3>& target);

    Drag drag_ = Drag::none;
    Button button_{};
    int modifiers_ = no_modifier; // that it was pressed with
    vec2 at_{0.0f};
    vec2 pressed_at_{0.0f};
    bool is_click_ = false; // the pointer has not moved yet
    bool has_inertia_;
    Drag gliding_ = Drag::none;
    vec2 travelled_{0.0f}; // since the last frame [heights of the window]
    vec2 velocity_{0.0f};  // [heights of the window / s]
};

/// One step of a flight: `direction` along the camera's axes (x right, y up, z back).
void fly(Viewpoint& view, vec3 direction, float metres);

class Navigate : public Tool {
public:
    explicit Navigate(Workspace& workspace) : Tool(workspace), navigation_(workspace.options.has_inertia) {}

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw_section() override;
    bool holds_pointer() const override { return navigation_.is_dragging(); }
    Activity activity() const override {
        return navigation_.is_flying() || navigation_.is_gliding() ? Activity::active : Activity::idle;
    }

private:
    std::optional<Changes> execute(Command command);
    Changes next_camera();
    std::string left_out() const;
    Changes copy_view();
    Changes paste_view();
    scene::Bounds selection() const;

    Navigation navigation_;
    std::size_t camera_index_ = 0; // of the file's cameras, where next_camera() goes on from
};

} // namespace sr::viewer
