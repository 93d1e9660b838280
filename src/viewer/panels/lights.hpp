#pragma once
// Lights section of the main panel, and the marks of lights in the picture.
#include "viewer/changes.hpp"
#include "viewer/document/light_selection.hpp"
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

    /// Draws the section. `selected`: entries of `lights`, which the panel changes. `wanted`: set to
    /// the command of a button. `message`: set if there is something to report.
    Changes draw(LightEditor& lights, const LoadedScene& loaded, LightSelection& selected,
                 std::optional<Command>& wanted, const Keymap& keys, std::string& message);

    /// True if the pointer was over the list in the last frame: arrows go through it.
    bool has_pointer_in_list() const { return has_pointer_in_list_; }

private:
    Changes draw_list(LightEditor& lights, const LoadedScene& loaded, LightSelection& selected);
    Changes draw_value(LightEditor& lights, const LoadedScene& loaded, const LightSelection& selected,
                       std::string& message);
    Changes draw_color(LightEditor& lights, const LightSelection& selected);
    Changes type_value(LightEditor& lights, const LoadedScene& loaded, const LightSelection& selected,
                       std::string& message);
    Changes draw_place(LightEditor& lights, const LightSelection& selected);
    static Changes draw_sizes(LightEditor& lights, std::size_t selected);
    Changes draw_name(LightEditor& lights, std::size_t selected);
    static void draw_buttons(bool has_selected, const Keymap& keys, std::optional<Command>& wanted);

    std::array<char, 64> typed_{};
    std::array<char, 128> name_{};
    FocusRequest focus_;
    FocusRequest name_focus_;
    vec3 turn_{0.0f};    // about X, Y, Z since the light was selected [degrees]
    float scale_ = 1.0f; // likewise
    LightSelection was_selected_;
    bool has_pointer_in_list_ = false;
};

/// Place of an entry: the mean of its lights; absent if none has a place.
std::optional<vec3> center_of(const LightEditor& lights, std::size_t entry);

/// Place of several entries: the mean of their places; absent if none has one.
std::optional<vec3> center_of(const LightEditor& lights, const LightSelection& selected);

/// Draws marks at the selected lights and at lights without a surface.
void draw_light_marks(const LightEditor& lights, const LightSelection& selected, const Projection& projection,
                      float scale);

/// The entry whose mark is under the pointer; absent if there is none.
std::optional<std::size_t> mark_under(const LightEditor& lights, const Projection& projection, vec2 pointer);

} // namespace sr::viewer
