#include "viewer/lighting.hpp"

#include "core/error.hpp"
#include "scene/emitters.hpp"
#include "scene/light_surfaces.hpp"
#include "viewer/extents.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {
namespace {

std::string name_of(const scene::Light& light) {
    return std::visit([](const auto& l) { return l.name; }, light);
}

/// The lights that are off shine with nothing: they stay where they are, so that all others keep their
/// numbers.
void darken(std::vector<scene::Light>& lights, const std::vector<bool>& on) {
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (!on[i]) set_quantity(lights[i], vec3(0.0f));
}

} // namespace

Lighting::Lighting(const LoadedScene& loaded, bool hides_emitters) : hides_emitters_(hides_emitters) {
    const scene::Scene& scene = loaded.stage.scene;
    state_.lights = scene.lights;
    std::size_t emitters = scene.lights.size();
    for (std::size_t i = 0; i < loaded.base.instances; ++i)
        emitters = std::max(emitters, static_cast<std::size_t>(scene.instances[i].emits_as.end));
    state_.softboxes.assign(loaded.stage.lights.begin() + static_cast<std::ptrdiff_t>(emitters),
                            loaded.stage.lights.end());
    for (std::size_t m = 0; m < loaded.base.materials; ++m) {
        state_.emission.push_back(loaded.emission[m]);
        material_names_.push_back(scene.materials[m].name);
    }
    state_.lights_on.assign(state_.lights.size(), true);
    state_.softboxes_on.assign(state_.softboxes.size(), true);
    state_.emission_on.assign(state_.emission.size(), true);
    for (std::size_t i = 0; i < state_.lights.size(); ++i) state_.origins.push_back(static_cast<int>(i));
    state_.moved.assign(state_.lights.size(), mat4(1.0f));
    state_.resized.assign(state_.lights.size(), false);
    original_ = state_;
    staged_ = loaded.stage.lights;
    list(loaded.stage, emitters);
}

void Lighting::list(const scene::Stage& stage, std::size_t first_softbox) {
    lamps_.clear();
    for (std::size_t i = 0; i < state_.lights.size(); ++i)
        lamps_.push_back(
            {Lamp::Kind::light, i, name_of(state_.lights[i]), {static_cast<int>(i)}, state_.lights_on[i]});
    for (std::size_t m = 0; m < state_.emission.size(); ++m) {
        Lamp lamp{Lamp::Kind::surface, m, material_names_[m], {}, state_.emission_on[m]};
        for (const scene::Instance& instance : stage.scene.instances) {
            const auto material = stage.scene.meshes[static_cast<std::size_t>(instance.mesh)].material;
            if (static_cast<std::size_t>(material) != m) continue;
            for (int k = instance.emits_as.first; k < instance.emits_as.end; ++k) lamp.lights.push_back(k);
            if (lamp.name.empty()) lamp.name = instance.name;
        }
        if (!lamp.lights.empty()) lamps_.push_back(std::move(lamp));
    }
    for (std::size_t i = 0; i < state_.softboxes.size(); ++i)
        lamps_.push_back({Lamp::Kind::softbox,
                          i,
                          name_of(state_.softboxes[i]),
                          {static_cast<int>(first_softbox + i)},
                          state_.softboxes_on[i]});
    for (std::size_t i = 0; i < lamps_.size(); ++i)
        if (lamps_[i].name.empty()) lamps_[i].name = fmt::format("light {}", i);
}

std::optional<std::size_t> Lighting::lamp_of_instance(const scene::Stage& stage, int instance) const {
    const scene::LightRange range = stage.scene.instances[static_cast<std::size_t>(instance)].emits_as;
    for (std::size_t i = 0; i < lamps_.size(); ++i)
        if (std::ranges::any_of(lamps_[i].lights, [&](int k) { return range.contains(k); })) return i;
    return std::nullopt;
}

std::vector<scene::Light> Lighting::lights_of(std::size_t lamp) const {
    std::vector<scene::Light> lights;
    for (const int k : lamps_[lamp].lights) lights.push_back(staged_[static_cast<std::size_t>(k)]);
    return lights;
}

void Lighting::remember() {
    if (is_step_open_) return;
    constexpr std::size_t most = 200;
    if (history_.size() == most) history_.erase(history_.begin());
    history_.push_back(state_);
    undone_.clear();
    is_step_open_ = true;
}

std::vector<bool>& Lighting::switches(Lamp::Kind kind) {
    if (kind == Lamp::Kind::light) return state_.lights_on;
    return kind == Lamp::Kind::surface ? state_.emission_on : state_.softboxes_on;
}

void Lighting::set_quantity(std::size_t index, vec3 quantity) {
    const Lamp& lamp = lamps_[index];
    if (quantity == vec3(0.0f))
        return switch_to(index, false); // a surface without emission would be no light
    remember();
    switches(lamp.kind)[lamp.index] = true;
    if (lamp.kind == Lamp::Kind::light) viewer::set_quantity(state_.lights[lamp.index], quantity);
    if (lamp.kind == Lamp::Kind::softbox) {
        viewer::set_quantity(state_.softboxes[lamp.index], quantity);
        state_.softboxes_changed = true;
    }
    if (lamp.kind == Lamp::Kind::surface) state_.emission[lamp.index] = quantity;
}

void Lighting::switch_to(std::size_t index, bool is_on) {
    remember();
    switches(lamps_[index].kind)[lamps_[index].index] = is_on;
}

void Lighting::solo(std::size_t index) {
    const bool is_alone = std::ranges::all_of(
        lamps_, [&](const Lamp& lamp) { return lamp.is_on == (&lamp == &lamps_[index]); });
    remember();
    for (const Lamp& lamp : lamps_) switches(lamp.kind)[lamp.index] = is_alone || &lamp == &lamps_[index];
}

bool Lighting::transform(std::size_t index, const mat4& by) {
    if (!can_move(index)) return false;
    remember();
    const Lamp& lamp = lamps_[index];
    scene::Light& light = light_of(lamp);
    light = transformed(light, by);
    if (lamp.kind == Lamp::Kind::light)
        state_.moved[lamp.index] = by * state_.moved[lamp.index];
    else
        state_.softboxes_changed = true;
    return true;
}

void Lighting::set_size(std::size_t index, std::size_t extent, float size) {
    require(can_move(index), "surfaces keep their sizes");
    remember();
    const Lamp& lamp = lamps_[index];
    viewer::set_size(light_of(lamp), extent, size);
    if (lamp.kind == Lamp::Kind::light)
        state_.resized[lamp.index] = true;
    else
        state_.softboxes_changed = true;
}

scene::Light& Lighting::light_of(const Lamp& lamp) {
    return lamp.kind == Lamp::Kind::light ? state_.lights[lamp.index] : state_.softboxes[lamp.index];
}

std::size_t Lighting::add(scene::Light light) {
    remember();
    state_.lights.push_back(std::move(light));
    state_.lights_on.push_back(true);
    state_.origins.push_back(-1);
    state_.moved.push_back(mat4(1.0f));
    state_.resized.push_back(false);
    return state_.lights.size() - 1; // lights come first in the list
}

bool Lighting::remove(std::size_t index) {
    const Lamp lamp = lamps_[index];
    if (lamp.kind == Lamp::Kind::surface) {
        switch_to(index, false);
        return false;
    }
    remember();
    const auto at = static_cast<std::ptrdiff_t>(lamp.index);
    auto& lights = lamp.kind == Lamp::Kind::light ? state_.lights : state_.softboxes;
    lights.erase(lights.begin() + at);
    auto& on = switches(lamp.kind);
    on.erase(on.begin() + at);
    if (lamp.kind == Lamp::Kind::light) {
        state_.origins.erase(state_.origins.begin() + at);
        state_.moved.erase(state_.moved.begin() + at);
        state_.resized.erase(state_.resized.begin() + at);
    } else {
        state_.softboxes_changed = true;
    }
    return true;
}

bool Lighting::undo() {
    is_step_open_ = false;
    if (history_.empty()) return false;
    undone_.push_back(std::exchange(state_, std::move(history_.back())));
    history_.pop_back();
    return true;
}

bool Lighting::redo() {
    is_step_open_ = false;
    if (undone_.empty()) return false;
    history_.push_back(std::exchange(state_, std::move(undone_.back())));
    undone_.pop_back();
    return true;
}

void Lighting::take_back_step() {
    if (is_step_open_) state_ = history_.back();
}

void Lighting::cancel_step() {
    if (!is_step_open_) return;
    state_ = std::move(history_.back());
    history_.pop_back();
    is_step_open_ = false;
}

void Lighting::apply(LoadedScene& loaded) {
    scene::Scene& scene = loaded.stage.scene;
    scene.instances.resize(loaded.base.instances);
    scene.materials.resize(loaded.base.materials);
    scene.meshes.resize(loaded.base.meshes);
    scene.lights = state_.lights;
    for (std::size_t m = 0; m < state_.emission.size(); ++m) scene.materials[m].emission = state_.emission[m];
    std::vector<scene::Light>& lights = loaded.stage.lights;
    lights = scene::assign_emitters(scene);
    const std::size_t first_softbox = lights.size();
    lights.insert(lights.end(), state_.softboxes.begin(), state_.softboxes.end());
    staged_ = lights;
    list(loaded.stage, first_softbox);
    for (const Lamp& lamp : lamps_) {
        if (lamp.is_on) continue;
        for (const int k : lamp.lights) viewer::set_quantity(lights[static_cast<std::size_t>(k)], vec3(0.0f));
        if (lamp.kind == Lamp::Kind::surface) scene.materials[lamp.index].emission = vec3(0.0f);
    }
    darken(scene.lights, state_.lights_on); // their surfaces go dark, too
    if (hides_emitters_)
        for (scene::Material& material : scene.materials) material.emission = vec3(0.0f);
    else
        scene::add_light_surfaces(scene);
}

} // namespace sr::viewer
