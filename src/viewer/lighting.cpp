#include "viewer/lighting.hpp"

#include "core/error.hpp"
#include "scene/prepare.hpp"
#include "scene/lights/light.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sr::viewer {

Lighting::Lighting(const LoadedScene& loaded, bool hides_emitters) : hides_emitters_(hides_emitters) {
    const scene::Scene& scene = loaded.stage.scene;
    std::size_t emitters = scene.lights.size();
    for (std::size_t i = 0; i < loaded.base.instances; ++i)
        emitters = std::max(emitters, static_cast<std::size_t>(scene.instances[i].emits_as.end));
    state_.softboxes.assign(loaded.stage.lights.begin() + static_cast<std::ptrdiff_t>(emitters),
                            loaded.stage.lights.end());
    state_.emission = loaded.emission;
    name_materials(scene, loaded.base.materials);
    state_.softboxes_on.assign(state_.softboxes.size(), true);
    state_.emission_on.assign(state_.emission.size(), true);
    state_.emission_given.assign(state_.emission.size(), false);
    file_.take(loaded);
    viewer::follow(state_, file_);
    staged_ = loaded.stage.lights;
    list(loaded.stage, emitters);
}

void Lighting::name_materials(const scene::Scene& scene, std::size_t count) {
    material_names_.clear();
    for (std::size_t m = 0; m < count; ++m) material_names_.push_back(scene.materials[m].name);
}

void Lighting::list(const scene::Stage& stage, std::size_t first_softbox) {
    lamps_.clear();
    int staged = 0, added = 0;
    for (std::size_t i = 0; i < state_.lights.size(); ++i) {
        const int id = state_.origins[i] < 0 ? --added : state_.origins[i];
        if (!state_.lights_there[i]) continue;
        lamps_.push_back(
            {Lamp::Kind::light, i, name_of(state_.lights[i]), {staged++}, state_.lights_on[i], id});
    }
    for (std::size_t m = 0; m < state_.emission.size(); ++m) {
        Lamp lamp{Lamp::Kind::surface, m, material_names_[m], {}, state_.emission_on[m], file_.materials[m]};
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
                          state_.softboxes_on[i],
                          static_cast<int>(i)});
    for (std::size_t i = 0; i < lamps_.size(); ++i)
        if (lamps_[i].name.empty()) lamps_[i].name = fmt::format("light {}", i);
}

std::optional<std::size_t> Lighting::lamp_like(const Lamp& lamp) const {
    const auto found = std::ranges::find_if(
        lamps_, [&](const Lamp& other) { return other.kind == lamp.kind && other.id == lamp.id; });
    if (found == lamps_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - lamps_.begin());
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
    if (lamp.kind == Lamp::Kind::light) {
        scene::set_quantity(state_.lights[lamp.index], quantity);
        state_.lights_given[lamp.index] = true;
    }
    if (lamp.kind == Lamp::Kind::softbox) {
        scene::set_quantity(state_.softboxes[lamp.index], quantity);
        state_.softboxes_changed = true;
    }
    if (lamp.kind == Lamp::Kind::surface) {
        state_.emission[lamp.index] = quantity;
        state_.emission_given[lamp.index] = true;
    }
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
    scene::set_size(light_of(lamp), extent, size);
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
    state_.lights_given.push_back(true);
    state_.lights_there.push_back(true);
    state_.origins.push_back(-1);
    state_.moved.push_back(mat4(1.0f));
    state_.resized.push_back(false);
    return static_cast<std::size_t>(std::ranges::count(state_.lights_there, true))
           - 1; // they come first in the list
}

bool Lighting::remove(std::size_t index) {
    const Lamp lamp = lamps_[index];
    if (lamp.kind == Lamp::Kind::surface) {
        switch_to(index, false);
        return false;
    }
    remember();
    const auto drop = [&](auto&... values) {
        (values.erase(values.begin() + static_cast<std::ptrdiff_t>(lamp.index)), ...);
    };
    if (lamp.kind == Lamp::Kind::light) {
        if (lamp.id >= 0) state_.removed.push_back(lamp.id);
        drop(state_.lights, state_.lights_on, state_.lights_given, state_.lights_there, state_.origins,
             state_.moved, state_.resized);
    } else {
        drop(state_.softboxes, state_.softboxes_on);
        state_.softboxes_changed = true;
    }
    return true;
}

bool Lighting::undo() { return step(history_, undone_); }
bool Lighting::redo() { return step(undone_, history_); }

bool Lighting::step(std::vector<LightingState>& from, std::vector<LightingState>& to) {
    is_step_open_ = false;
    if (from.empty()) return false;
    to.push_back(std::exchange(state_, std::move(from.back())));
    from.pop_back();
    viewer::follow(state_, file_); // it may be of another moment
    return true;
}

void Lighting::take_back_step() {
    if (!is_step_open_) return;
    state_ = history_.back();
    viewer::follow(state_, file_);
}

void Lighting::cancel_step() {
    if (!is_step_open_) return;
    state_ = std::move(history_.back());
    history_.pop_back();
    viewer::follow(state_, file_);
    is_step_open_ = false;
}

bool Lighting::adds_or_removes() const {
    return !state_.removed.empty() || state_.softboxes_changed
           || std::ranges::any_of(state_.origins, [](int origin) { return origin < 0; })
           || std::ranges::count(state_.softboxes_on, false) > 0;
}

void Lighting::follow(const LoadedScene& loaded) {
    const FileLights before = file_;
    file_.take(loaded);
    if (file_.materials != before.materials) {
        for (std::vector<LightingState>* states : {&history_, &undone_})
            for (LightingState& state : *states) renumber(state, before, file_);
        renumber(state_, before, file_);
        name_materials(loaded.stage.scene, loaded.base.materials);
    }
    viewer::follow(state_, file_);
}

void Lighting::apply(LoadedScene& loaded) {
    scene::Scene& scene = loaded.stage.scene;
    scene.instances.resize(loaded.base.instances);
    scene.materials.resize(loaded.base.materials);
    scene.meshes.resize(loaded.base.meshes);
    scene.lights.clear();
    for (std::size_t i = 0; i < state_.lights.size(); ++i)
        if (state_.lights_there[i]) scene.lights.push_back(state_.lights[i]);
    for (std::size_t m = 0; m < state_.emission.size(); ++m) scene.materials[m].emission = state_.emission[m];
    std::vector<scene::Light>& lights = loaded.stage.lights;
    lights = scene::assign_emitters(scene);
    const std::size_t first_softbox = lights.size();
    lights.insert(lights.end(), state_.softboxes.begin(), state_.softboxes.end());
    staged_ = lights;
    list(loaded.stage, first_softbox);
    // What is off shines with nothing: it stays where it is, so that all others keep their numbers.
    for (const Lamp& lamp : lamps_) {
        if (lamp.is_on) continue;
        for (const int k : lamp.lights) scene::set_quantity(lights[static_cast<std::size_t>(k)], vec3(0.0f));
        if (lamp.kind == Lamp::Kind::surface) scene.materials[lamp.index].emission = vec3(0.0f);
        if (lamp.kind == Lamp::Kind::light) // its surface goes dark, too
            scene::set_quantity(scene.lights[static_cast<std::size_t>(lamp.lights.front())], vec3(0.0f));
    }
    if (hides_emitters_)
        for (scene::Material& material : scene.materials) material.emission = vec3(0.0f);
    else
        scene::add_light_surfaces(scene);
}

} // namespace sr::viewer
