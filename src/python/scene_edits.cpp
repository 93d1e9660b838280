// Edits of Python in a scene that is rendered, and in a file that is saved.
#include "core/error.hpp"
#include "python/lights.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace sr::python {
namespace {

/// The light of a file at a time, with a person's edits.
scene::Light edited(const scene::Light& file, const EditableLight& edit) {
    scene::Light light = edit.motion == mat4(1.0f) ? file : transformed(file, edit.motion);
    if (edit.has_new_sizes) take_sizes_of(light, edit.light);
    if (edit.has_new_quantity) set_quantity(light, quantity_of(edit.light));
    if (edit.has_new_name) set_name(light, name_of(edit.light));
    return light;
}

void apply_materials(const std::vector<EditableMaterial>& edits, scene::Scene& scene) {
    for (const EditableMaterial& edit : edits) {
        scene::Material& material = scene.materials.at(static_cast<std::size_t>(edit.index));
        if (edit.has_new_base_color) material.base_color = edit.factors.base_color;
        if (edit.has_new_metallic) material.metallic = edit.factors.metallic;
        if (edit.has_new_roughness) material.roughness = edit.factors.roughness;
        if (edit.has_new_emission) material.emission = edit.factors.emission;
    }
}

gltf::StatedEmission stated(double value, scene::Quantity quantity, scene::UnitSystem units, vec3 color) {
    return {value, scene::name_of({quantity, units}), color};
}

gltf::StatedEmission emission_of(const EditableLight& edit) {
    const vec3 quantity = quantity_of(edit.light);
    if (!has_profile(edit.light))
        return stated(luminance(quantity), quantity_kind_of(edit.light), edit.units, quantity);
    return stated(luminance(*flux_of(edit.light, edit.profiles)), scene::Quantity::flux, edit.units,
                  quantity);
}

gltf::NodeLightEdit node_edit(const EditableLight& edit, int node) {
    gltf::NodeLightEdit written;
    written.node = node;
    // A flux makes another radiance of another size, so a new size restates the emission.
    if (edit.has_new_quantity || edit.has_new_sizes) written.emission = emission_of(edit);
    if (edit.has_new_sizes) written.sizes = sizes_of(edit.light);
    if (edit.has_new_name) written.name = name_of(edit.light);
    written.motion = edit.motion;
    return written;
}

gltf::MaterialEdit material_edit(const EditableMaterial& edit, int number, scene::UnitSystem units) {
    gltf::MaterialEdit written;
    written.material = number;
    const scene::Material& factors = edit.factors;
    if (edit.has_new_emission)
        written.emission =
            stated(luminance(factors.emission), scene::Quantity::radiance, units, factors.emission);
    written.is_specular_glossiness = factors.is_specular_glossiness;
    if (edit.has_new_base_color) written.base_color = factors.base_color;
    if (edit.has_new_metallic) written.metallic = factors.metallic;
    if (edit.has_new_roughness) written.roughness = factors.roughness;
    return written;
}

gltf::NodeLightEdit removal(int node) {
    gltf::NodeLightEdit written;
    written.node = node;
    written.is_removed = true;
    return written;
}

/// The edits to the file's own lights, the first of each number; all others are added.
class FileLights {
public:
    FileLights(const gltf::Contents& contents, const std::string& file)
        : nodes_(contents.light_nodes), is_kept_(nodes_.size(), false), file_(file) {}

    void write(const EditableLight& light, gltf::Edits& written) {
        const auto number = static_cast<std::size_t>(light.source);
        if (light.source < 0 || is_kept_[number]) {
            written.added_lights.push_back({light.light, emission_of(light)});
            return;
        }
        is_kept_[number] = true;
        if (light.is_edited()) written.lights.push_back(node_edit(light, own_node(number)));
    }

    void write_removals(gltf::Edits& written) const {
        for (std::size_t number = 0; number < nodes_.size(); ++number)
            if (!is_kept_[number]) written.lights.push_back(removal(own_node(number)));
    }

private:
    /// @throws Error if the node has another light as well
    int own_node(std::size_t number) const {
        const int node = nodes_[number];
        if (std::ranges::count(nodes_, node) > 1)
            throw Error({file_},
                        fmt::format("/nodes/{} has several lights, and one of them was edited", node),
                        "give each light a node of its own");
        return node;
    }

    const std::vector<int>& nodes_;
    std::vector<bool> is_kept_;
    std::string file_;
};

} // namespace

void apply(const SceneEdits& edits, scene::Scene& scene, const std::vector<int>& numbers, bool is_at_rest) {
    apply_materials(edits.materials, scene);
    if (!edits.lights) return;
    const std::vector<scene::Light> now = std::exchange(scene.lights, {});
    for (const EditableLight& edit : *edits.lights) {
        const auto found = std::ranges::find(numbers, edit.source);
        if (edit.source < 0)
            scene.lights.push_back(edit.light);
        else if (found != numbers.end())
            scene.lights.push_back(
                is_at_rest ? edit.light
                           : edited(now[static_cast<std::size_t>(found - numbers.begin())], edit));
    }
    for (std::size_t i = 0; i < now.size(); ++i)
        if (numbers[i] < 0) scene.lights.push_back(now[i]);
}

gltf::Edits file_edits(const SceneEdits& edits, const gltf::Contents& contents, scene::UnitSystem units,
                       const std::string& file) {
    gltf::Edits written;
    if (edits.lights) {
        FileLights lights(contents, file);
        for (const EditableLight& light : *edits.lights) lights.write(light, written);
        lights.write_removals(written);
    }
    for (const EditableMaterial& edit : edits.materials) {
        const int number = contents.material_numbers[static_cast<std::size_t>(edit.index)];
        if (number < 0)
            throw Error({file}, "glTF's default material was edited, which no file states",
                        "give its meshes a material");
        written.materials.push_back(material_edit(edit, number, units));
    }
    return written;
}

} // namespace sr::python
