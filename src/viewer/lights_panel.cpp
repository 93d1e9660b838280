#include "viewer/lights_panel.hpp"

#include "core/error.hpp"
#include "scene/lights/light.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <imgui.h>

namespace sr::viewer {
namespace {

LightGroup group_of(const std::vector<scene::Light>& lights, const scene::Scene& scene) {
    return {lights, scene.profiles, scene.units};
}

/// A mark stands for what the picture does not show.
bool needs_mark(const LightEditor& lighting, std::size_t lamp) {
    if (lighting.entries()[lamp].kind == LightEdit::Kind::softbox) return true;
    const auto lights = lighting.lights_of(lamp);
    return lights.size() == 1
           && (std::holds_alternative<scene::PointLight>(lights[0])
               || std::holds_alternative<scene::SpotLight>(lights[0]));
}

scene::RectangleLight new_rectangle(vec3 at) {
    scene::RectangleLight light;
    light.name = "new rectangle";
    light.center = at;
    light.half_u = vec3(0.25f, 0.0f, 0.0f);
    light.half_v = vec3(0.0f, 0.0f, 0.25f); // it shines downwards
    light.L = vec3(1000.0f);
    return light;
}

} // namespace

std::optional<vec3> center_of(const LightEditor& lighting, std::size_t lamp) {
    vec3 sum(0.0f);
    float count = 0.0f;
    for (const scene::Light& light : lighting.lights_of(lamp))
        if (const auto center = center_of(light)) {
            sum += *center;
            count += 1.0f;
        }
    return count > 0.0f ? std::optional(sum / count) : std::nullopt;
}

LightChange LightsPanel::draw(LightEditor& lighting, const LoadedScene& loaded, vec3 new_light_at,
                              std::string& message) {
    if (selected && *selected >= lighting.entries().size()) selected.reset();
    if (selected != was_selected_) {
        turn_ = vec3(0.0f);
        scale_ = 1.0f;
        typed_.fill('\0');
        was_selected_ = selected;
    }
    if (focus_.is_open()) ImGui::SetNextItemOpen(true);
    if (!ImGui::CollapsingHeader("Lights", ImGuiTreeNodeFlags_DefaultOpen)) return LightChange::none;
    LightChange change = draw_list(lighting, loaded);
    if (selected) change = std::max(change, draw_value(lighting, loaded, message));
    if (selected) change = std::max(change, draw_place(lighting));
    return std::max(change, draw_new(lighting, new_light_at));
}

LightChange LightsPanel::draw_list(LightEditor& lighting, const LoadedScene& loaded) {
    LightChange change = LightChange::none;
    for (std::size_t i = 0; i < lighting.entries().size(); ++i) {
        const LightEntry& lamp = lighting.entries()[i];
        const auto lights = lighting.lights_of(i);
        ImGui::PushID(static_cast<int>(i));
        bool is_on = lamp.is_enabled;
        if (ImGui::Checkbox("##on", &is_on)) {
            lighting.begin_step();
            lighting.enable(i, is_on);
            change = LightChange::quantity;
        }
        ImGui::SameLine();
        if (ImGui::Selectable(lamp.name.c_str(), selected == i)) selected = i;
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", value_text(group_of(lights, loaded.stage.scene)).c_str());
        ImGui::PopID();
    }
    return change;
}

LightChange LightsPanel::draw_value(LightEditor& lighting, const LoadedScene& loaded, std::string& message) {
    const auto lights = lighting.lights_of(*selected);
    const LightGroup group = group_of(lights, loaded.stage.scene);
    LightChange change = LightChange::none;
    ImGui::TextDisabled("%s", value_text(group).c_str());
    if (focus_.is_open()) ImGui::SetKeyboardFocusHere();
    const bool is_entered = ImGui::InputTextWithHint("value", "800 lm, 6500 K", typed_.data(), typed_.size(),
                                                     ImGuiInputTextFlags_EnterReturnsTrue);
    focus_.tell(ImGui::IsItemActive());
    if (is_entered) {
        try {
            const vec3 quantity = typed_quantity(typed_.data(), group);
            lighting.begin_step();
            lighting.set_quantity(*selected, quantity);
            message = fmt::format("{}: {}", lighting.entries()[*selected].name, typed_.data());
            change = LightChange::quantity;
            typed_.fill('\0');
        } catch (const Error& error) {
            message = error.what();
        }
    }
    vec3 color = quantity_of(lights.front());
    const float brightest = std::max({color.r, color.g, color.b, 1e-30f});
    color /= brightest;
    const bool is_changed = ImGui::ColorEdit3("colour", &color.x, ImGuiColorEditFlags_Float);
    if (ImGui::IsItemActivated()) lighting.begin_step();
    if (is_changed && color != vec3(0.0f)) {
        lighting.set_quantity(*selected, color * brightest);
        change = LightChange::quantity;
    }
    return change;
}

LightChange LightsPanel::draw_place(LightEditor& lighting) {
    const std::size_t lamp = *selected;
    if (!lighting.can_move(lamp)) return LightChange::none;
    LightChange change = LightChange::none;
    const auto transform = [&](const mat4& by) {
        if (ImGui::IsItemActivated()) lighting.begin_step();
        lighting.transform(lamp, by);
        change = LightChange::place;
    };
    const auto center = center_of(lighting, lamp);
    const vec3 pivot = center.value_or(vec3(0.0f));
    if (center) {
        vec3 moved = pivot;
        if (ImGui::DragFloat3("place [m]", &moved.x, 0.01f, 0.0f, 0.0f, "%.3f"))
            transform(glm::translate(mat4(1.0f), moved - pivot));
    }
    vec3 turn = turn_;
    if (ImGui::DragFloat3("turn [deg]", &turn.x, 1.0f, -360.0f, 360.0f, "%.0f")) {
        mat4 rotation(1.0f);
        for (int axis = 0; axis < 3; ++axis) {
            vec3 unit(0.0f);
            unit[axis] = 1.0f;
            rotation = glm::rotate(mat4(1.0f), glm::radians(turn[axis] - turn_[axis]), axis_direction(axis))
                       * rotation;
        }
        turn_ = turn;
        transform(around(pivot, rotation));
    }
    float scale = scale_;
    if (center
        && ImGui::DragFloat("size [x]", &scale, 0.01f, 0.01f, 100.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp)) {
        const float by = scale / scale_;
        scale_ = scale;
        transform(around(pivot, glm::scale(mat4(1.0f), vec3(by))));
    }
    const std::vector<scene::LightSize> extents = scene::sizes_of(lighting.lights_of(lamp).front());
    for (std::size_t i = 0; i < extents.size(); ++i) {
        float size = extents[i].size;
        const std::string label = fmt::format("{} [m]", extents[i].key);
        const bool is_changed = ImGui::DragFloat(label.c_str(), &size, 0.01f * size, 1e-4f, 1e4f, "%.4g",
                                                 ImGuiSliderFlags_AlwaysClamp);
        if (ImGui::IsItemActivated()) lighting.begin_step();
        if (!is_changed) continue;
        lighting.set_size(lamp, i, size);
        change = LightChange::place;
    }
    return change;
}

LightChange LightsPanel::draw_new(LightEditor& lighting, vec3 at) {
    const auto add = [&](scene::Light light) {
        lighting.begin_step();
        selected = lighting.add(std::move(light));
        return LightChange::place;
    };
    if (ImGui::Button("+ point")) return add(scene::PointLight{"new point", at, vec3(100.0f)});
    ImGui::SameLine();
    if (ImGui::Button("+ rectangle")) return add(new_rectangle(at));
    ImGui::SameLine();
    if (ImGui::Button("+ sphere")) return add(scene::SphereLight{"new sphere", at, 0.1f, vec3(3000.0f)});
    return LightChange::none;
}

void LightsPanel::draw_marks(const LightEditor& lighting, const Projection& projection, float scale) const {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    constexpr ImU32 orange = IM_COL32(230, 159, 0, 255), grey = IM_COL32(220, 220, 220, 160);
    for (std::size_t i = 0; i < lighting.entries().size(); ++i) {
        const bool is_selected = selected == i;
        const auto center = center_of(lighting, i);
        const auto at = center ? projection(*center) : std::nullopt;
        if (!at || (!is_selected && !needs_mark(lighting, i))) continue;
        list.AddCircle({at->x, at->y}, 6.0f * scale, is_selected ? orange : grey, 0,
                       is_selected ? 2.5f : 1.5f);
    }
}

std::optional<std::size_t> LightsPanel::mark_under(const LightEditor& lighting, const Projection& projection,
                                                   vec2 pointer) {
    constexpr float slack = 9.0f; // [pixels]
    for (std::size_t i = 0; i < lighting.entries().size(); ++i) {
        if (!needs_mark(lighting, i)) continue;
        const auto center = center_of(lighting, i);
        const auto at = center ? projection(*center) : std::nullopt;
        if (at && glm::distance(*at, pointer) <= slack) return i;
    }
    return std::nullopt;
}

} // namespace sr::viewer
