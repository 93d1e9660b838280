#include "gltf/load.hpp"

#include "gltf/camera.hpp"
#include "gltf/decode.hpp"
#include "gltf/document.hpp"
#include "gltf/extensions.hpp"
#include "gltf/hierarchy.hpp"
#include "gltf/light.hpp"
#include "gltf/material.hpp"
#include "gltf/mesh.hpp"
#include "gltf/warnings.hpp"

#include <map>

namespace sr::gltf {
namespace {

const tinygltf::Node& node_of(const Document& document, const PlacedNode& placed) {
    return document.model.nodes[static_cast<std::size_t>(placed.node)];
}

// The number of a primitive's material in the Scene, for every primitive that some placed node draws.
class UsedMeshes {
public:
    UsedMeshes(const Document& document, const std::vector<PlacedNode>& placed, MaterialTable& materials) {
        for (const PlacedNode& node : placed) {
            const int mesh = node_of(document, node).mesh;
            if (mesh < 0 || materials_.contains(mesh)) continue;
            std::vector<int>& numbers = materials_[mesh];
            for (const auto& primitive : document.model.meshes[static_cast<std::size_t>(mesh)].primitives)
                numbers.push_back(materials.material(primitive.material));
        }
    }

    /// Appends the mesh's primitives to the scene the first time. @return where they are in Scene::meshes
    const std::vector<int>& meshes(const Document& document, int mesh, scene::Scene& scene,
                                   Warnings& warnings) {
        const auto [found, is_new] = meshes_.try_emplace(mesh);
        if (!is_new) return found->second;
        const std::vector<int>& materials = materials_.at(mesh);
        for (int primitive = 0; primitive < static_cast<int>(materials.size()); ++primitive) {
            const int material = materials[static_cast<std::size_t>(primitive)];
            auto made = mesh_of(document, {mesh, primitive},
                                scene.materials[static_cast<std::size_t>(material)], warnings);
            if (!made || made->indices.empty()) continue;
            made->material = material;
            found->second.push_back(static_cast<int>(scene.meshes.size()));
            scene.meshes.push_back(*std::move(made));
        }
        return found->second;
    }

private:
    std::map<int, std::vector<int>> materials_;
    std::map<int, std::vector<int>> meshes_;
};

void append_instances(const Document& document, const std::vector<PlacedNode>& placed, UsedMeshes& used,
                      scene::Scene& scene, Warnings& warnings) {
    for (const PlacedNode& here : placed) {
        const tinygltf::Node& node = node_of(document, here);
        if (node.mesh < 0) continue;
        if (node.skin >= 0) warnings.add("a skinned mesh is not supported yet", "shown in its rest pose");
        for (const int mesh : used.meshes(document, node.mesh, scene, warnings))
            scene.instances.push_back({mesh, mat4(here.world_from_node), node.name});
    }
    if (scene.instances.empty())
        warnings.add("no node of the scene has a mesh with triangles", "there is nothing to see");
}

} // namespace

Loaded load(const std::filesystem::path& file, const LoadOptions& options) {
    const Document document = read_document(file);
    Warnings warnings(document.name);
    warn_of_unsupported(document.model.extensionsUsed, warnings);
    warnings.add("an animation is not supported yet", "shown in its rest pose", document.animation_count);

    Loaded loaded;
    loaded.extensions_used = document.model.extensionsUsed;
    scene::Scene& scene = loaded.scene;
    const std::vector<PlacedNode> placed = placed_nodes(document, options.scene);

    MaterialTable materials(document, warnings);
    UsedMeshes used(document, placed, materials);
    scene.materials = materials.materials();
    scene.measured = materials.measured();
    LightTable lights(document, materials.textures());
    for (const PlacedNode& here : placed) lights.append(here);
    scene.lights = lights.lights();
    scene.profiles = lights.profiles();
    scene.units = unit_system_of(document);
    scene.textures = materials.textures().textures();
    Decoding decoding(document, materials.textures().image_sources());

    for (const PlacedNode& here : placed)
        if (node_of(document, here).camera >= 0) scene.cameras.push_back(camera_at(document, here));
    append_instances(document, placed, used, scene, warnings);
    materials.share_fluxes(scene);
    scene.images = decoding.images();

    loaded.warnings = warnings.lines();
    return loaded;
}

} // namespace sr::gltf
