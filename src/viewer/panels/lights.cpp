#include "viewer/panels/lights.hpp"

#include "core/error.hpp"
#include "scene/lights/light.hpp"
#include "viewer/fields.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <imgui.h>
#include <span>

namespace sr::viewer {
namespace {

LightGroup group_of(const std::vector<scene::Light>& lights, const scene::Scene& scene) {
    return {lights, scene.profiles, scene.units};
}

/// True for a light without a surface in the picture.
bool needs_mark(const LightEditor& editor, std::size_t entry) {
    if (editor.entries()[entry].kind == LightEdit::Kind::softbox) return true;
    const auto lights = editor.lights_of(entry);
    return lights.size() == 1
           && (std::holds_alternative<scene::PointLight>(lights[0])
               || std::holds_alternative<scene::SpotLight>(lights[0]));
}

constexpr Changes shape = Change::lights | Change::shadows; // a light was moved, resized, added or removed

} // namespace

std::optional<vec3> center_of(const LightEditor& editor, std::size_t entry) {
    vec3 sum(0.0f);
    float count = 0.0f;
    for (const scene::Light& light : editor.lights_of(entry))
        if (const auto center = center_of(light)) {
            sum += *center;
            count += 1.0f;
        }
    return count > 0.0f ? std::optional(sum / count) : std::nullopt;
}

std::optional<vec3> center_of(const LightEditor& editor, const LightSelection& selected) {
    vec3 sum(0.0f);
    float count = 0.0f;
    for (const std::size_t entry : selected.entries())
        if (const auto center = center_of(editor, entry); center && editor.can_move(entry)) {
            sum += *center;
            count += 1.0f;
        }
    return count > 0.0f ? std::optional(sum / count) : std::nullopt;
}

Changes LightsPanel::draw(LightEditor& editor, const LoadedScene& loaded, LightSelection& selected,
                          std::optional<Command>& wanted, const Keymap& keys, std::string& message) {
    has_pointer_in_list_ = false;
    selected.keep_below(editor.entries().size());
    if (selected != was_selected_) {
        turn_ = vec3(0.0f);
        scale_ = 1.0f;
        typed_.fill('\0');
        name_.fill('\0');
        if (selected) editor.entries()[*selected].name.copy(name_.data(), name_.size() - 1);
        was_selected_ = selected;
    }
    if (focus_.is_pending() || name_focus_.is_pending()) ImGui::SetNextItemOpen(true);
    const bool is_unfolded = ImGui::CollapsingHeader("Lights", ImGuiTreeNodeFlags_DefaultOpen);
    tooltip(
        "lights of the file, environment, studio, and materials that emit; Tab selects the next. Ctrl click, "
        "Shift click and Shift with up or down select several, which are edited together");
    if (!is_unfolded) return {};
    Changes changes = draw_list(editor, loaded, selected);
    if (selected) {
        if (selected.count() == 1) changes |= draw_name(editor, *selected);
        changes |= draw_value(editor, loaded, selected, message);
        changes |= draw_place(editor, selected);
        if (selected.count() == 1) changes |= draw_sizes(editor, *selected);
    }
    draw_buttons(static_cast<bool>(selected), keys, wanted);
    return focus_.is_pending() || name_focus_.is_pending() ? changes | Change::redraw : changes;
}

Changes LightsPanel::draw_list(LightEditor& editor, const LoadedScene& loaded, LightSelection& selected) {
    Changes change;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < editor.entries().size(); ++i) {
        const LightEntry& entry = editor.entries()[i];
        const auto lights = editor.lights_of(i);
        ImGui::PushID(static_cast<int>(i));
        bool is_on = entry.is_enabled;
        if (ImGui::Checkbox("##on", &is_on)) {
            const bool is_of_several = selected.contains(i);
            editor.begin_step(is_of_several ? selected.count() : 1);
            editor.enable(i, is_on);
            for (const std::size_t other : selected.entries())
                if (is_of_several) editor.enable(other, is_on);
            change |= Change::lights;
        }
        tooltip("on; a light without the tick emits nothing and keeps its place");
        ImGui::SameLine();
        if (ImGui::Selectable(entry.name.c_str(), selected.contains(i))) {
            if (ImGui::GetIO().KeyShift)
                selected.extend_to(i);
            else if (ImGui::GetIO().KeyCtrl)
                selected.toggle(i);
            else
                selected = i;
        }
        tooltip(with_superscripts(value_text(group_of(lights, loaded.stage.scene))));
        ImGui::PopID();
    }
    ImGui::EndGroup();
    has_pointer_in_list_ = ImGui::IsItemHovered(ImGuiHoveredFlags_RectOnly)
                           && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
    return change;
}

/// Gives all selected lights the typed value, each in its own quantity. If one of them cannot take it, none
/// does.
Changes LightsPanel::type_value(LightEditor& editor, const LoadedScene& loaded,
                                const LightSelection& selected, std::string& message) {
    try {
        std::vector<vec3> quantities;
        for (const std::size_t entry : selected.entries()) {
            const auto lights = editor.lights_of(entry);
            quantities.push_back(parse_quantity(typed_.data(), group_of(lights, loaded.stage.scene)));
        }
        editor.begin_step(selected.count());
        for (std::size_t i = 0; i < quantities.size(); ++i)
            editor.set_quantity(selected.entries()[i], quantities[i]);
        message = fmt::format("{}: {}",
                              selected.count() == 1 ? editor.entries()[*selected].name
                                                    : fmt::format("{} lights", selected.count()),
                              typed_.data());
        typed_.fill('\0');
        return Change::lights;
    } catch (const Error& error) {
        message = error.what();
        return {};
    }
}

Changes LightsPanel::draw_value(LightEditor& editor, const LoadedScene& loaded,
                                const LightSelection& selected, std::string& message) {
    const auto lights = editor.lights_of(*selected);
    Changes change;
    if (selected.count() > 1)
        ImGui::TextDisabled("%zu lights; the values of %s:", selected.count(),
                            editor.entries()[*selected].name.c_str());
    ImGui::TextDisabled("%s", with_superscripts(value_text(group_of(lights, loaded.stage.scene))).c_str());
    if (focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    const bool is_entered = ImGui::InputTextWithHint("value", "800 lm, 6500 K, +1 EV", typed_.data(),
                                                     typed_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    focus_.update(ImGui::IsItemActive());
    tooltip("a number with a unit (cd, lm, lx, cd/m^2, W, ...) for each of the selected lights, kelvins for "
            "their colour, or +1 EV for twice as much; Enter takes it");
    if (is_entered) change |= type_value(editor, loaded, selected, message);
    return change | draw_color(editor, selected);
}

Changes LightsPanel::draw_color(LightEditor& editor, const LightSelection& selected) {
    const auto brightest = [](vec3 quantity) {
        return std::max({quantity.r, quantity.g, quantity.b, 1e-30f});
    };
    const auto quantity = [&](std::size_t entry) { return quantity_of(editor.lights_of(entry).front()); };
    vec3 color = quantity(*selected) / brightest(quantity(*selected));
    const bool is_changed = color_field("colour", std::span(&color.x, 3));
    if (ImGui::IsItemActivated()) editor.begin_step(selected.count());
    tooltip(
        "linear red, green and blue of the light, the brightest as 1; the value above keeps the brightest");
    if (!is_changed || color == vec3(0.0f)) return {};
    for (const std::size_t entry : selected.entries())
        editor.set_quantity(entry, color * brightest(quantity(entry)));
    return Change::lights;
}

Changes LightsPanel::draw_place(LightEditor& editor, const LightSelection& selected) {
    const auto can_move = [&](std::size_t entry) { return editor.can_move(entry); };
    if (std::ranges::none_of(selected.entries(), can_move)) return {};
    Changes change;
    const auto transform = [&](const mat4& by) {
        if (ImGui::IsItemActivated()) editor.begin_step(selected.count());
        for (const std::size_t entry : selected.entries()) editor.transform(entry, by);
        change |= shape;
    };
    const auto center = center_of(editor, selected);
    const vec3 pivot = center.value_or(vec3(0.0f));
    if (center) {
        vec3 moved = pivot;
        if (number_field("place [m]", moved, {}, 0.01f)) transform(glm::translate(mat4(1.0f), moved - pivot));
        tooltip("x, y, z of the centre of what is selected, in the scene [m]; a drag changes a number, a "
                "click with Ctrl types it");
    }
    vec3 turn = turn_;
    if (number_field("turn [deg]", turn, {-360.0f, 360.0f, "%.0f", false}, 1.0f)) {
        mat4 rotation(1.0f);
        for (int axis = 0; axis < 3; ++axis) {
            rotation = glm::rotate(mat4(1.0f), glm::radians(turn[axis] - turn_[axis]), axis_direction(axis))
                       * rotation;
        }
        turn_ = turn;
        transform(around(pivot, rotation));
    }
    tooltip("turns around the axes X, Y and Z of the world [degrees], since it was selected");
    float scale = scale_;
    if (center && number_field("size [x]", scale, {0.01f, 100.0f, "%.2f"}, 0.01f)) {
        const float by = scale / scale_;
        scale_ = scale;
        transform(around(pivot, glm::scale(mat4(1.0f), vec3(by))));
    }
    if (center) tooltip("factor of all its extents, since it was selected");
    return change;
}

Changes LightsPanel::draw_sizes(LightEditor& editor, std::size_t selected) {
    if (!editor.can_move(selected)) return {};
    Changes change;
    const std::vector<scene::LightSize> extents = scene::sizes_of(editor.lights_of(selected).front());
    for (std::size_t i = 0; i < extents.size(); ++i) {
        float size = extents[i].size;
        const std::string label = fmt::format("{} [m]", extents[i].key);
        const bool is_changed = number_field(label, size, {1e-4f, 1e4f, "%.4g"}, 0.01f * size);
        if (ImGui::IsItemActivated()) editor.begin_step();
        tooltip("an extent of the light [m]; its radiance stays, so that a larger light gives more");
        if (!is_changed) continue;
        editor.set_size(selected, i, size);
        change |= shape;
    }
    return change;
}

/// Draws the name as a field. The name of a material stays.
Changes LightsPanel::draw_name(LightEditor& editor, std::size_t selected) {
    if (!editor.can_move(selected)) return {};
    if (name_focus_.is_pending()) ImGui::SetKeyboardFocusHere();
    const bool is_entered =
        ImGui::InputText("name", name_.data(), name_.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    name_focus_.update(ImGui::IsItemActive());
    tooltip("the light's name, which a saved file has; Enter takes it");
    if (!is_entered || name_[0] == '\0' || editor.entries()[selected].name == name_.data()) return {};
    editor.begin_step();
    editor.rename(selected, name_.data());
    return Change::lights;
}

void LightsPanel::draw_buttons(bool has_selected, const Keymap& keys, std::optional<Command>& wanted) {
    const auto button = [&](const char* label, Command command, const char* tip) {
        if (ImGui::Button(label)) wanted = command;
        tooltip(keys.hint(tip, command));
    };
    button("+ add", Command::add_light, "add a light of any kind");
    ImGui::SameLine();
    button("mixer", Command::mix_lights, "faders, mute and solo of all lights");
    if (!has_selected) return;
    ImGui::SameLine();
    button("duplicate", Command::duplicate_light, "add copies of the selected lights");
    const float width = ImGui::CalcTextSize("remove").x + 2.0f * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine(); // a narrow column
    button("remove", Command::delete_light, "remove the selected lights");
}

void draw_light_marks(const LightEditor& editor, const LightSelection& selected, const Projection& projection,
                      float scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    constexpr ImU32 faint = IM_COL32(220, 220, 220, 160);
    for (std::size_t i = 0; i < editor.entries().size(); ++i) {
        const bool is_selected = selected.contains(i);
        const auto center = center_of(editor, i);
        const auto at = center ? projection(*center) : std::nullopt;
        if (!at || (!is_selected && !needs_mark(editor, i))) continue;
        list.AddCircle({at->x, at->y}, 6.0f * scale, is_selected ? palette::orange : faint, 0,
                       is_selected ? 2.5f : 1.5f);
    }
}

std::optional<std::size_t> mark_under(const LightEditor& editor, const Projection& projection, vec2 pointer) {
    constexpr float mark_slack = 9.0f; // [pixels]
    for (std::size_t i = 0; i < editor.entries().size(); ++i) {
        if (!needs_mark(editor, i)) continue;
        const auto center = center_of(editor, i);
        const auto at = center ? projection(*center) : std::nullopt;
        if (at && glm::distance(*at, pointer) <= mark_slack) return i;
    }
    return std::nullopt;
}

} // namespace sr::viewer
