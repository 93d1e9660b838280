#pragma once
// Writer of a glTF file with other lights, another emission and another first camera.
#include "scene/camera.hpp"
#include "scene/lights/light.hpp"

#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

namespace sr::gltf {

/// The quantity and the colour that extras.steradian states.
struct StatedEmission {
    double value = 0.0;    // luminance of the quantity, in `unit`
    std::string_view unit; // one of scene::unit_names
    vec3 color{1.0f};      // linear RGB, of any luminance
};

/// Edits to the light of a node.
struct NodeLightEdit {
    int node = 0;
    bool is_removed = false;
    std::optional<std::string> name;        // of the node
    std::optional<StatedEmission> emission; // absent: as the file states it
    std::vector<scene::LightSize> sizes;    // all of the light's, in the world; none: as the file states them
    mat4 motion{1.0f}; // from the light's place in the file to its new place, in the scene
};

/// Edits to the emission of a material.
struct MaterialEdit {
    int material = 0;
    StatedEmission emission;
};

/// True if a copy can have such a light at a node of its own: not for polygons, meshes and environments, and
/// not with a picture or a photometric profile.
bool is_addable(const scene::Light& light);

/// A light that the file does not have, and that is_addable().
struct AddedLight {
    scene::Light light;
    StatedEmission emission;
};

struct Edits {
    std::vector<NodeLightEdit> lights;
    std::vector<MaterialEdit> materials;
    std::vector<AddedLight> added_lights;
    std::optional<scene::Camera> first_camera;
    std::optional<int> scene_index; // of the scene that new nodes belong to; absent: the file's default scene
    glm::dvec3 origin{0.0};         // of the scene in the file's world (Scene::origin)
};

/// Writes a copy of `file` with `edits` to `target`, in the same container. What is not edited keeps its
/// JSON.
/// @throws Error if `target` is in another folder (the file's URIs would lead nowhere), has another
/// extension, or cannot be written
void write_edited_copy(const std::filesystem::path& file, const Edits& edits,
                       const std::filesystem::path& target);

} // namespace sr::gltf
