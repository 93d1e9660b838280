#pragma once
// Lights and materials as Python edits them.
#include "gltf/asset.hpp"
#include "gltf/write/edited_copy.hpp"
#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::python {

/// A light of a scene, or a new one.
struct EditableLight {
    scene::Light light;
    glm::dvec3 origin{0.0}; // Scene::origin, which the light is relative to
    scene::UnitSystem units = scene::UnitSystem::photometric;
    std::vector<scene::LightProfile> profiles; // of its scene, where the light has one
    int file = 0;                              // number of the SceneFile that it is of; 0: of none
    int source = -1;                           // number of the light in that file; negative: a new one
    mat4 motion{1.0f};                         // from its place in the file to its place now, in the scene
    bool has_new_quantity = false;             // as the next two: a person's, at every time
    bool has_new_sizes = false;
    bool has_new_name = false;

    bool is_edited() const {
        return source < 0 || has_new_quantity || has_new_sizes || has_new_name || motion != mat4(1.0f);
    }
};

/// A material, and which of its factors are a person's.
struct EditableMaterial {
    int index = 0;           // in Scene::materials
    scene::Material factors; // as they are now
    bool has_new_base_color = false;
    bool has_new_metallic = false;
    bool has_new_roughness = false;
    bool has_new_emission = false;

    bool is_edited() const {
        return has_new_base_color || has_new_metallic || has_new_roughness || has_new_emission;
    }
};

/// All edits of a scene.
struct SceneEdits {
    std::optional<std::vector<EditableLight>> lights; // in the place of the file's
    std::vector<EditableMaterial> materials;          // those that are edited
};

/// Brings the edits to a scene. `numbers` has for each of its lights the number that EditableLight::source
/// means; negative for a light that the file does not show at rest. Edited lights go with the file's
/// animations; at rest they are as Python sees them, to the bit.
void apply(const SceneEdits& edits, scene::Scene& scene, const std::vector<int>& numbers, bool is_at_rest);

/// Returns the edits as a file states them.
/// @throws Error for an edited light that shares its node with another one, and for glTF's default material
gltf::Edits file_edits(const SceneEdits& edits, const gltf::Contents& contents, scene::UnitSystem units,
                       const std::string& file);

/// The lights of a scene at rest, which is that of the SceneFile number `file`.
std::vector<EditableLight> lights_of(const scene::Scene& scene, int file);
std::vector<EditableMaterial> materials_of(const scene::Scene& scene);

} // namespace sr::python
