#pragma once
// Light mixer: a fader, a colour, mute and solo for each light.
#include "viewer/changes.hpp"
#include "viewer/document/light_selection.hpp"
#include "viewer/ui.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::viewer {

/// Lights with names that differ in their last number alone ("panel 1", "panel 2") are faded together.
struct MixerGroup {
    std::string name;                 // without the number
    std::vector<std::size_t> entries; // of LightEditor::entries()
};

/// All lights in their order; a light with a name of its own is a group of one.
std::vector<MixerGroup> mixer_groups(const std::vector<LightEntry>& entries);

class MixerPanel {
public:
    /// Takes the quantities that faders at 0 stand for.
    void begin(const LightEditor& lights);

    /// Draws the panel into `area`, or floating if it is absent. `progress`: a line about the pictures of the
    /// lights. Sets `closes` if a person is done.
    Changes draw(LightEditor& lights, const LoadedScene& loaded, LightSelection& selected,
                 const std::string& progress, const std::optional<Area>& area, const Ui& ui, bool& closes);

private:
    Changes draw_group(const MixerGroup& group, LightEditor& lights, const LoadedScene& loaded,
                       LightSelection& selected);
    static Changes draw_group_switches(const MixerGroup& group, LightEditor& lights);
    Changes draw_group_fader(const MixerGroup& group, LightEditor& lights);
    Changes draw_light(std::size_t entry, LightEditor& lights, const LoadedScene& loaded,
                       LightSelection& selected);
    Changes draw_fader(std::size_t entry, LightEditor& lights, const LoadedScene& loaded);

    std::vector<vec3> at_zero_; // quantity of each entry
};

} // namespace sr::viewer
