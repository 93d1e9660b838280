#pragma once
// Lights and materials as Python edits them.
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
    bool is_edited = false;
};

/// The factors of a material that can be edited; absent ones are the file's.
struct EditableMaterial {
    int index = 0;           // in Scene::materials
    scene::Material factors; // as they are now
    bool is_edited = false;
};

/// All edits of a scene.
struct SceneEdits {
    std::optional<std::vector<scene::Light>> lights; // in the place of the file's
    std::vector<EditableMaterial> materials;         // those that are edited
};

/// Brings the edits to a scene that is as its file says.
void apply(const SceneEdits& edits, scene::Scene& scene);

std::vector<EditableLight> lights_of(const scene::Scene& scene);
std::vector<EditableMaterial> materials_of(const scene::Scene& scene);

} // namespace sr::python
