#include "viewer/panels/mixer.hpp"

#include "core/math.hpp"
#include "viewer/fields.hpp"
#include "viewer/light_value.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr float fader_range = 8.0f; // [EV] up and down

/// A small button that is lit while it is pressed in.
bool switch_button(const char* label, bool is_in, ImU32 color, const char* tip) {
    if (is_in) ImGui::PushStyleColor(ImGuiCol_Button, color);
    const bool is_clicked = ImGui::Button(label, {1.6f * ImGui::GetFontSize(), 0.0f});
    if (is_in) ImGui::PopStyleColor();
    tooltip(tip);
    return is_clicked;
}

float exposure_between(vec3 from, vec3 to) {
    const float a = luminance(from), b = luminance(to);
    return a > 0.0f && b > 0.0f ? std::log2(b / a) : 0.0f;
}

bool is_alone(const LightEditor& lights, std::size_t entry) {
    const auto& entries = lights.entries();
    return entries.size() > 1 && std::ranges::all_of(entries, [&](const LightEntry& other) {
               return other.is_enabled == (&other == &entries[entry]);
           });
}

/// A name without a number at its end, and without what joins it: "panel" of "panel 12" and "panel.012".
std::string stem_of(const std::string& name) {
    const auto last = name.find_last_not_of("0123456789");
    if (last == std::string::npos || last + 1 == name.size()) return name;
    const auto end = name.find_last_not_of(" ._-#", last);
    return end == std::string::npos ? name : name.substr(0, end + 1);
}

/// Names a step of undo that changes a group.
std::string step_of(const char* what, const MixerGroup& group) {
    return fmt::format("{} {}, {} lights", what, group.name, group.entries.size());
}

} // namespace

std::vector<MixerGroup> mixer_groups(const std::vector<LightEntry>& entries) {
    std::vector<MixerGroup> groups;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string stem = stem_of(entries[i].name);
        const auto known = std::ranges::find(groups, stem, &MixerGroup::name);
        if (known == groups.end())
            groups.push_back({stem, {i}});
        else
            known->entries.push_back(i);
    }
    return groups;
}

void MixerPanel::begin(const LightEditor& lights) {
    at_zero_.clear();
    for (std::size_t i = 0; i < lights.entries().size(); ++i)
        at_zero_.push_back(quantity_of(lights.lights_of(i).front()));
}

Changes MixerPanel::draw_fader(std::size_t entry, LightEditor& lights, const LoadedScene& loaded) {
    const auto all = lights.lights_of(entry);
    const vec3 quantity = quantity_of(all.front());
    float ev = exposure_between(at_zero_[entry], quantity);
    const LightGroup group{all, loaded.stage.scene.profiles, loaded.stage.scene.units};
    const std::string value = with_superscripts(value_text(group));
    std::string format = fmt::format("%+.2f EV  ({})", value.substr(0, value.find(','))); // without its flux
    ImGui::SetNextItemWidth(-1.0f);
    if (field_width_of(format) > ImGui::GetContentRegionAvail().x) format = "%+.2f EV";
    const bool is_moved = ImGui::SliderFloat("##fader", &ev, -fader_range, fader_range, format.c_str(),
                                             ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemActivated()) lights.begin_step();
    tooltip(value
            + "\n1 EV doubles the light; 0 is the value from before. Ctrl click: type; double click: 0.");
    const bool is_reset = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    if (!is_moved && !is_reset) return {};
    const float wanted = is_reset ? 0.0f : ev;
    const float by = std::exp2(wanted - exposure_between(at_zero_[entry], quantity));
    lights.brighten(entry, by);
    return Change::lights;
}

Changes MixerPanel::draw_light(std::size_t entry, LightEditor& lights, const LoadedScene& loaded,
                               LightSelection& selected) {
    Changes changes;
    ImGui::PushID(static_cast<int>(entry));
    const bool is_on = lights.entries()[entry].is_enabled;
    if (switch_button("M", !is_on, palette::vermilion, "mute: this light off, or on again")) {
        lights.begin_step();
        lights.enable(entry, !is_on);
        changes |= Change::lights;
    }
    ImGui::SameLine(0.0f, 3.0f);
    if (switch_button("S", is_alone(lights, entry), palette::green, "solo: this light alone, or all again")) {
        lights.begin_step();
        lights.solo({entry});
        changes |= Change::lights;
    }
    ImGui::SameLine(0.0f, 3.0f);
    const vec3 quantity = quantity_of(lights.lights_of(entry).front());
    const float brightest = std::max({quantity.r, quantity.g, quantity.b, 1e-30f});
    vec3 color = quantity / brightest;
    const bool is_colored =
        ImGui::ColorEdit3("##colour", &color.x, ImGuiColorEditFlags_Float | ImGuiColorEditFlags_NoInputs);
    if (ImGui::IsItemActivated()) lights.begin_step();
    tooltip("the light's colour, linear, the brightest channel as 1; a click changes it");
    if (is_colored && color != vec3(0.0f)) {
        lights.set_quantity(entry, color * brightest);
        changes |= Change::lights;
    }
    ImGui::SameLine();
    if (!is_on) ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(palette::grey));
    if (ImGui::Selectable(lights.entries()[entry].name.c_str(), selected.contains(entry))) selected = entry;
    if (!is_on) ImGui::PopStyleColor();
    changes |= draw_fader(entry, lights, loaded);
    ImGui::PopID();
    return changes;
}

/// Mute and solo of a group.
Changes MixerPanel::draw_group_switches(const MixerGroup& group, LightEditor& lights) {
    Changes changes;
    const auto is_member = [&](std::size_t i) {
        return std::ranges::find(group.entries, i) != group.entries.end();
    };
    const auto& entries = lights.entries();
    bool is_any_on = false, is_solo = group.entries.size() < entries.size();
    for (std::size_t i = 0; i < entries.size(); ++i) {
        is_any_on = is_any_on || (is_member(i) && entries[i].is_enabled);
        is_solo = is_solo && entries[i].is_enabled == is_member(i);
    }
    const auto switch_all = [&](const char* what, auto is_on) {
        lights.begin_step(group.entries.size(), step_of(what, group));
        for (std::size_t i = 0; i < lights.entries().size(); ++i) lights.enable(i, is_on(i));
        changes |= Change::lights;
    };
    if (switch_button("M", !is_any_on, palette::vermilion, "mute: these lights off, or on again"))
        switch_all(is_any_on ? "disabling" : "enabling",
                   [&](std::size_t i) { return is_member(i) ? !is_any_on : entries[i].is_enabled; });
    ImGui::SameLine(0.0f, 3.0f);
    if (switch_button("S", is_solo, palette::green, "solo: these lights alone, or all again"))
        switch_all("enabling alone", [&](std::size_t i) { return is_solo || is_member(i); });
    return changes;
}

/// A fader that brightens all members by as much; it shows the first one's.
Changes MixerPanel::draw_group_fader(const MixerGroup& group, LightEditor& lights) {
    const auto quantity = [&](std::size_t i) { return quantity_of(lights.lights_of(i).front()); };
    const std::size_t first = group.entries.front();
    const float before = exposure_between(at_zero_[first], quantity(first));
    float ev = before;
    ImGui::SetNextItemWidth(-1.0f);
    const bool is_moved = ImGui::SliderFloat("##group", &ev, -fader_range, fader_range, "%+.2f EV  (all)",
                                             ImGuiSliderFlags_AlwaysClamp);
    if (ImGui::IsItemActivated()) lights.begin_step(group.entries.size(), step_of("value of", group));
    tooltip(
        "brightens all lights of the group by as much, and muted ones stay muted; 1 EV doubles them. Ctrl "
        "click: type");
    if (!is_moved) return {};
    for (const std::size_t i : group.entries) lights.brighten(i, std::exp2(ev - before));
    return Change::lights;
}

Changes MixerPanel::draw_group(const MixerGroup& group, LightEditor& lights, const LoadedScene& loaded,
                               LightSelection& selected) {
    if (group.entries.size() == 1) return draw_light(group.entries.front(), lights, loaded, selected);
    constexpr std::size_t few = 12; // lights that a panel shows one by one from the start
    ImGui::PushID(group.name.c_str());
    Changes changes = draw_group_switches(group, lights);
    ImGui::SameLine();
    const int flags = lights.entries().size() <= few ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    const bool is_open =
        ImGui::TreeNodeEx("members", flags, "%s, %zu lights", group.name.c_str(), group.entries.size());
    tooltip("lights whose names differ in a number; a click shows or folds them");
    changes |= draw_group_fader(group, lights);
    if (is_open) {
        for (const std::size_t entry : group.entries) changes |= draw_light(entry, lights, loaded, selected);
        ImGui::TreePop();
    }
    ImGui::PopID();
    return changes;
}

Changes MixerPanel::draw(LightEditor& lights, const LoadedScene& loaded, LightSelection& selected,
                         const std::string& progress, const std::optional<Area>& area, const Ui& ui,
                         bool& closes) {
    Changes changes;
    if (area)
        place_next_window(*area);
    else
        ImGui::SetNextWindowSize({20.0f * ImGui::GetFontSize(), 0.0f});
    if (ImGui::Begin(side::mixer, nullptr,
                     ui.panel_flags(area.has_value()) & ~ImGuiWindowFlags_AlwaysAutoResize)) {
        if (area) heading(side::mixer, ui);
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled("%s", progress.c_str());
        ImGui::PopTextWrapPos();
        if (at_zero_.size() == lights.entries().size())
            for (const MixerGroup& group : mixer_groups(lights.entries()))
                changes |= draw_group(group, lights, loaded, selected);
        ImGui::Spacing();
        closes = ImGui::Button("done");
        tooltip("render the picture with these lights");
    }
    if (!area) keep_in_viewport();
    ImGui::End();
    return changes;
}

} // namespace sr::viewer
