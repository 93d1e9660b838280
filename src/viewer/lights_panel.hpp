#pragma once
// The list of lights, and the one that is selected.
#include "viewer/document/light_edits.hpp"
#include "viewer/focus.hpp"
#include "viewer/gizmo.hpp"

#include <array>
#include <string>

namespace sr::viewer {

/// What a panel did to the lights.
enum class LightChange {
    none,
    quantity, // how bright
    place,    // what casts shadows has moved, come or gone
};

class LightsPanel {
public:
    std::optional<std::size_t> selected;

    /// The text field of the selected light takes the keyboard.
    void edit() { focus_.wish(); }
    bool wants_focus() const { return focus_.is_open(); }

    /// Draws the panel. @return what changed; `message` is what to tell the person
    LightChange draw(LightEditor& lighting, const LoadedScene& loaded, vec3 new_light_at,
                     std::string& message);

    /// Draws marks at lights that have no surface, and at the selected one.
    void draw_marks(const LightEditor& lighting, const Projection& projection, float scale) const;

    /// The light whose mark is under the pointer.
    static std::optional<std::size_t> mark_under(const LightEditor& lighting, const Projection& projection,
                                                 vec2 pointer);

private:
    LightChange draw_list(LightEditor& lighting, const LoadedScene& loaded);
    LightChange draw_value(LightEditor& lighting, const LoadedScene& loaded, std::string& message);
    LightChange draw_place(LightEditor& lighting);
    LightChange draw_new(LightEditor& lighting, vec3 at);

    std::array<char, 64> typed_{};
    FocusWish focus_;
    vec3 turn_{0.0f};    // degrees about X, Y, Z that were asked for since the selection
    float scale_ = 1.0f; // likewise
    std::optional<std::size_t> was_selected_;
};

/// Where lamp stands, if it is somewhere; of several surfaces the middle.
std::optional<vec3> center_of(const LightEditor& lighting, std::size_t lamp);

} // namespace sr::viewer
