#include "viewer/document/file_lights.hpp"

#include "scene/lights/light.hpp"

#include <algorithm>
#include <utility>

namespace sr::viewer {
namespace {

using Kind = LightEdit::Kind;

scene::Light edited(const scene::Light& file, const LightEdit& edit) {
    scene::Light light = edit.motion == mat4(1.0f) ? file : transformed(file, edit.motion);
    if (edit.overrides_size) scene::take_sizes_of(light, edit.light);
    if (edit.overrides_quantity) set_quantity(light, quantity_of(edit.light));
    if (edit.overrides_name) set_name(light, name_of(edit.light));
    return light;
}

auto found(std::vector<LightEdit>& edits, Kind kind, int source) {
    return std::ranges::find_if(
        edits, [=](const LightEdit& edit) { return edit.kind == kind && edit.source == source; });
}

/// Brings the edits of lights to another time. A light that was not seen before goes behind its predecessor.
void rebase_lights(std::vector<LightEdit>& edits, const FileLights& now) {
    std::ptrdiff_t at = 0;
    for (const FileLights::Light& light : now.lights) {
        auto known = found(edits, Kind::light, light.number);
        if (known == edits.end()) {
            LightEdit edit;
            edit.source = light.number;
            edit.light = light.light;
            edit.name = name_of(light.light);
            edit.node = now.node_of(light.number);
            known = edits.insert(edits.begin() + at, std::move(edit));
        } else {
            known->light = edited(light.light, *known);
            known->is_present = true;
        }
        at = known - edits.begin() + 1;
    }
}

/// Brings the edits of materials to another variant. Edits of materials that it does not show are kept.
void rebase_materials(std::vector<LightEdit>& edits, const FileLights& now) {
    for (std::size_t m = 0; m < now.materials.size(); ++m) {
        const FileLights::Material& material = now.materials[m];
        auto known = found(edits, Kind::material, material.number);
        if (known == edits.end()) {
            LightEdit edit;
            edit.kind = Kind::material;
            edit.source = material.number;
            known = edits.insert(edits.end(), std::move(edit));
        }
        known->is_present = true;
        known->material = m;
        known->name = material.name;
        if (!known->overrides_quantity) known->emission = material.emission;
    }
}

} // namespace

void rebase_edits(std::vector<LightEdit>& edits, const FileLights& now) {
    for (LightEdit& edit : edits)
        if (edit.kind != Kind::softbox && !edit.is_added()) edit.is_present = false;
    rebase_lights(edits, now);
    rebase_materials(edits, now);
}

bool are_at_same_places(const std::vector<LightEdit>& a, const std::vector<LightEdit>& b) {
    const auto sizes = [](const LightEdit& edit) {
        std::vector<float> all;
        for (const scene::LightSize& size : scene::sizes_of(edit.light)) all.push_back(size.size);
        return all;
    };
    return std::ranges::equal(a, b, [&](const LightEdit& x, const LightEdit& y) {
        return x.kind == y.kind && x.source == y.source && x.is_shown() == y.is_shown()
               && x.motion == y.motion && x.factors == y.factors && sizes(x) == sizes(y);
    });
}

void FileLights::read(const LoadedScene& loaded) {
    lights.clear();
    for (std::size_t i = 0; i < loaded.stage.scene.lights.size(); ++i) {
        // The lights of a node come one after the other, and all or none of them are visible.
        const int node = loaded.light_nodes[i];
        const bool is_next = i > 0 && loaded.light_nodes[i - 1] == node;
        const auto from = is_next ? nodes_.begin() + lights.back().number + 1 : nodes_.begin();
        const auto known = std::find(from, nodes_.end(), node);
        lights.push_back({loaded.stage.scene.lights[i], static_cast<int>(known - nodes_.begin())});
        if (known == nodes_.end()) nodes_.push_back(node);
    }
    materials.clear();
    for (std::size_t m = 0; m < loaded.emission.size(); ++m)
        materials.push_back({loaded.contents.material_numbers[m], loaded.emission[m],
                             loaded.stage.scene.materials[m].name, loaded.stage.scene.materials[m]});
}

bool FileLights::shares_its_node(int number) const { return std::ranges::count(nodes_, node_of(number)) > 1; }

} // namespace sr::viewer
