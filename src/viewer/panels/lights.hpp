#pragma once
// Lights section of the main panel, and the marks of lights in the picture.
#include "viewer/changes.hpp"
#include "viewer/document/light_edits.hpp"
#include "viewer/keymap.hpp"
#include "viewer/ui.hpp"
#include "viewer/view/projection.hpp"

#include <array>
#include <string>

namespace sr::viewer {

/// Message of commands that need a selected light.
inline constexpr const char* select_first = "Select a light first: click it or press Tab.";

class LightsPanel {
public:
    // Each gives the keyboard to a text field of the selected light.
    void edit() { focus_.begin(); }
    void rename() { name_focus_.begin(); }

    /// Draws the section. `selected`: an entry of `lights`, which the panel changes. `wanted`: set to
    /// the command of a button. `message`: set if there is something to report.
    Changes draw(LightEditor& lights, const LoadedScene& loaded, std::optional<std::size_t>& selected,
                 std::optional<Command>& wanted, const Keymap& keys, std::string& message);

private:
    Changes draw_list(LightEditor& lights, const LoadedScene& loaded, std::optional<std::size_t>& selected);
    Changes draw_value(LightEditor& lights, const LoadedScene& loaded, std::size_t selected,
                       std::string& message);
    Changes draw_place(LightEditor& lights, std::size_t selected);
    static Changes draw_sizes(LightEditor& lights, std::size_t selected);
    Changes draw_name(LightEditor& lights, std::size_t selected);
    static void draw_buttons(bool has_selected, const Keymap& keys, std::optional<Command>& wanted);

    std::array<char, 64> typed_{};
    std::array<char, 128> name_{};
    FocusRequest focus_;
    FocusRequest name_focus_;
    vec3 turn_{0.0f};    // about X, Y, Z since the light was selected [degrees]
    float scale_ = 1.0f; // likewise
    std::optional<std::size_t> was_selected_;
};

/// Place of an entry: the mean of its lights; absent if none has a place.
std::optional<vec3> center_of(const LightEditor& lights, std::size_t entry);

/// Draws marks at the selected light and at lights without a surface.
void draw_light_marks(const LightEditor& lights, std::optional<std::size_t> selected,
                      const Projection& projection, float scale);

/// The entry whose mark is under the pointer; absent if there is none.
std::optional<std::size_t> mark_under(const LightEditor& lights, const Projection& projection, vec2 pointer);

} // namespace sr::viewer
