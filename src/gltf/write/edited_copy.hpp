#pragma once
// Writer of a glTF file with other lights, another emission and another first camera.
#include "gltf/editable_factors.hpp"
#include "gltf/source_file.hpp"
#include "scene/camera.hpp"
#include "scene/lights/light.hpp"

#include <filesystem>
#include <optional>
#include <string>
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
    std::optional<StatedEmission> emission; // absent: as the file states it
    std::vector<scene::LightSize> sizes;    // all of the light's, in the world; none: as the file states them
    std::optional<std::string> name{};      // absent: as the file states it
    mat4 motion{1.0f}; // from the light's place in the file to its new place, in the scene
};

/// Edits to a material. What is absent is as the file states it.
struct MaterialEdit {
    int material = 0;
    std::optional<StatedEmission> emission;
    bool is_specular_glossiness = false; // the factors are those of KHR_materials_pbrSpecularGlossiness
    std::optional<vec4> base_color{};
    std::optional<float> metallic{};
    std::optional<float> roughness{};
    FactorValues others{}; // of editable_factors
};

/// True if a copy can have such a light at a node of its own: not with a picture, a profile or a surface of
/// its scene.
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

/// Writes a copy of `source`, as it was read, with `edits` to `target`, a .gltf or a .glb. What is not edited
/// keeps its JSON. A copy in another folder has within it the files that the original refers to, and any copy
/// has those of its buffers that have changed or gone since they were read.
/// @return one sentence for each other file that has changed or gone since, such as a texture
/// @throws Error if `target` has another extension or cannot be written, if a light cannot be stated
/// (light_json.hpp), or a file cannot be embedded (embedded_files.hpp)
std::vector<std::string> write_edited_copy(const SourceFile& source, const Edits& edits,
                                           const std::filesystem::path& target);

} // namespace sr::gltf
