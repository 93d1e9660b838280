#include "viewer/moment_lights.hpp"

#include "scene/lights/light.hpp"

#include <algorithm>

namespace sr::viewer {
namespace {

template<class Value>
void insert_at(std::vector<Value>& values, std::size_t at, Value value) {
    values.insert(values.begin() + static_cast<std::ptrdiff_t>(at), std::move(value));
}

void insert_light(LightingState& state, std::size_t at, const scene::Light& light, int number) {
    insert_at(state.lights, at, light);
    insert_at(state.lights_on, at, true);
    insert_at(state.lights_given, at, false);
    insert_at(state.lights_there, at, true);
    insert_at(state.origins, at, number);
    insert_at(state.moved, at, mat4(1.0f));
    insert_at(state.resized, at, false);
}

/// Gives a light the sizes of another one of its kind.
void take_sizes(scene::Light& light, const scene::Light& from) {
    const std::vector<scene::LightSize> sizes = scene::sizes_of(from);
    const std::size_t count = scene::sizes_of(light).size();
    const float across = sizes.size() < count ? 2.0f : 1.0f;   // a radius, where an ellipse became a circle
    for (std::size_t i = 0; i < scene::sizes_of(light).size(); ++i) // an ellipse may become a circle on the way
        set_size(light, i, across * sizes[std::min(i, sizes.size() - 1)].size);
}

scene::Light edited(const scene::Light& file, const LightingState& state, std::size_t at) {
    scene::Light light = state.moved[at] == mat4(1.0f) ? file : transformed(file, state.moved[at]);
    if (state.resized[at]) take_sizes(light, state.lights[at]);
    if (state.lights_given[at]) set_quantity(light, quantity_of(state.lights[at]));
    return light;
}

} // namespace

void FileLights::take(const LoadedScene& loaded) {
    lights = loaded.stage.scene.lights;
    emission = loaded.emission;
    materials = loaded.contents.material_numbers;
    numbers.clear();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        // Those of one node come one after the other, and all or none of them are visible.
        const int node = loaded.light_nodes[i];
        const bool is_next = i > 0 && loaded.light_nodes[i - 1] == node;
        const auto from = is_next ? nodes_.begin() + numbers.back() + 1 : nodes_.begin();
        const auto found = std::find(from, nodes_.end(), node);
        numbers.push_back(static_cast<int>(found - nodes_.begin()));
        if (found == nodes_.end()) nodes_.push_back(node);
    }
}

bool FileLights::shares_its_node(int number) const { return std::ranges::count(nodes_, node_of(number)) > 1; }

void follow(LightingState& state, const FileLights& now) {
    for (std::size_t i = 0; i < state.lights.size(); ++i) state.lights_there[i] = state.origins[i] < 0;
    std::size_t at = 0; // where a light that was not seen before comes to stand: after the one before it
    for (std::size_t k = 0; k < now.lights.size(); ++k) {
        const int number = now.numbers[k];
        if (std::ranges::find(state.removed, number) != state.removed.end()) continue;
        const auto known = std::ranges::find(state.origins, number);
        if (known == state.origins.end()) {
            insert_light(state, at, now.lights[k], number);
        } else {
            at = static_cast<std::size_t>(known - state.origins.begin());
            state.lights[at] = edited(now.lights[k], state, at);
            state.lights_there[at] = true;
        }
        ++at;
    }
    for (std::size_t m = 0; m < now.emission.size(); ++m)
        if (!state.emission_given[m]) state.emission[m] = now.emission[m];
}

void renumber(LightingState& state, const FileLights& before, const FileLights& now) {
    const LightingState old = state;
    state.emission = now.emission;
    state.emission_on.assign(now.emission.size(), true);
    state.emission_given.assign(now.emission.size(), false);
    for (std::size_t m = 0; m < now.emission.size(); ++m) {
        const auto known = std::ranges::find(before.materials, now.materials[m]);
        if (known == before.materials.end()) continue;
        const auto from = static_cast<std::size_t>(known - before.materials.begin());
        state.emission_on[m] = old.emission_on[from];
        state.emission_given[m] = old.emission_given[from];
        if (old.emission_given[from]) state.emission[m] = old.emission[from];
    }
}

} // namespace sr::viewer
