#include "gltf/drawn.hpp"

#include "gltf/accessor.hpp"
#include "gltf/instancing.hpp"
#include "gltf/variants.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::gltf {
namespace {

using glm::dmat4;

const tinygltf::Node& node_of(const Document& document, const PlacedNode& placed) {
    return document.model.nodes[static_cast<std::size_t>(placed.node)];
}

const std::vector<tinygltf::Primitive>& primitives_of(const Document& document, int mesh) {
    return document.model.meshes[static_cast<std::size_t>(mesh)].primitives;
}

/// The specification, section 3.7.2.2: a node's weights go before its mesh's.
const std::vector<double>& weights_of(const Document& document, const tinygltf::Node& node) {
    return node.weights.empty() ? document.model.meshes[static_cast<std::size_t>(node.mesh)].weights
                                : node.weights;
}

/// Returns the number of vertices that a primitive states: primitives may share their accessors.
std::uint64_t vertices_at_least(const Document& document, const tinygltf::Primitive& primitive) {
    const auto positions = primitive.attributes.find("POSITION");
    const std::uint64_t stated =
        positions == primitive.attributes.end() ? 0 : count_of(document, positions->second);
    const std::uint64_t corners = primitive.indices < 0 ? 0 : count_of(document, primitive.indices);
    return std::max(stated, corners / 3);
}

const dmat4 mirror{glm::dvec4(-1.0, 0.0, 0.0, 0.0), glm::dvec4(0.0, 1.0, 0.0, 0.0),
                   glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(0.0, 0.0, 0.0, 1.0)};

/// Tells the positions of a mesh whose vertices stand far out from its middle, so that a turn or a scale of
/// its node does not round them once more. @return that middle
glm::dvec3 moved_to_middle(scene::Mesh& mesh) {
    scene::Scene alone;
    alone.meshes.push_back({});
    alone.meshes[0].positions = mesh.positions;
    alone.instances.emplace_back();
    const glm::dvec3 middle = scene::fitting_origin(alone);
    if (middle != glm::dvec3(0.0))
        for (vec3& position : mesh.positions) position = vec3(glm::dvec3(position) - middle);
    return middle;
}

bool mirrors(const std::vector<dmat4>& joints) { return glm::determinant(glm::dmat3(joints[0])) < 0.0; }

} // namespace

DrawnMeshes::DrawnMeshes(const Document& document, const std::vector<PlacedNode>& placed,
                         std::optional<int> variant)
    : document_(document),
      placed_(placed),
      variant_(variant),
      made_count_(Limit::vertices, document.name),
      instance_count_(Limit::instances, document.name),
      vertex_count_(Limit::vertices, document.name),
      name_size_(Limit::names, document.name) {
    for (const PlacedNode& node : placed) {
        const int mesh = node_of(document, node).mesh;
        if (mesh >= 0 && std::ranges::find(meshes_, mesh) == meshes_.end()) meshes_.push_back(mesh);
    }
}

void DrawnMeshes::ask_for(MaterialTable& materials) const {
    for (const int mesh : meshes_)
        for (const tinygltf::Primitive& primitive : primitives_of(document_, mesh))
            materials.material(material_of(primitive, variant_));
}

void DrawnMeshes::read(MaterialTable& materials, scene::Scene& scene, Warnings& warnings) {
    std::map<int, std::vector<Part>> parts;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        const tinygltf::Node& node = node_of(document_, placed_[i]);
        if (node.mesh < 0) continue;
        const auto [found, is_new] = parts.try_emplace(node.mesh);
        if (is_new) found->second = parts_of(node.mesh, materials, scene, warnings);
        if (node.skin >= 0 && !skins_.contains(node.skin))
            skins_.emplace(node.skin, skin_of(document_, node.skin));
        for (Part& part : found->second) add(i, placed_[i], part, scene, warnings);
    }
    if (drawn_.empty())
        warnings.add("no node of the scene has a mesh with triangles, lines or points",
                     "there is nothing to see");
}

std::vector<DrawnMeshes::Part> DrawnMeshes::parts_of(int mesh, MaterialTable& materials, scene::Scene& scene,
                                                     Warnings& warnings) {
    std::vector<Part> parts;
    const auto& primitives = primitives_of(document_, mesh);
    for (int p = 0; p < static_cast<int>(primitives.size()); ++p) {
        const tinygltf::Primitive& primitive = primitives[static_cast<std::size_t>(p)];
        const int number = materials.material(material_of(primitive, variant_));
        const scene::Material& material = scene.materials[static_cast<std::size_t>(number)];
        const PrimitivePlace place{mesh, p};
        made_count_.add(vertices_at_least(document_, primitive));
        auto made = mesh_of(document_, place, material, warnings);
        if (!made || made->is_empty()) continue;
        made->material = number;
        Deformation deformation = deformation_of(document_, place, *made, material, warnings);
        Part part;
        const bool keeps_shape = deformation.targets.empty() && deformation.influences.per_vertex == 0;
        if (keeps_shape) part.middle = moved_to_middle(*made);
        if (!deformation.targets.empty() || deformation.influences.per_vertex > 0)
            part.deformation = std::make_shared<const Deformation>(std::move(deformation));
        part.rest = std::make_shared<const scene::Mesh>(static_cast<scene::Mesh&&>(*std::move(made)));
        parts.push_back(std::move(part));
    }
    return parts;
}

void DrawnMeshes::add(std::size_t placed, const PlacedNode& node, Part& part, scene::Scene& scene,
                      Warnings& warnings) {
    const int skin = node_of(document_, node).skin;
    const bool has_influences = part.deformation && part.deformation->influences.per_vertex > 0;
    if (skin >= 0 && !has_influences)
        warnings.add("a node has a skin, and its mesh has no joints and weights",
                     "it is shown without the skin");
    Drawn drawn{placed, part.mesh, has_influences ? skin : -1, nullptr, {dmat4(1.0)}};
    if (part.deformation && (drawn.skin >= 0 || !part.deformation->targets.empty()))
        drawn.deformation = part.deformation;
    if (drawn.skin >= 0)
        require_joints(drawn.skin, *part.deformation);
    else
        drawn.node_from_instance = instances_of(document_, node.node);
    for (dmat4& node_from_instance : drawn.node_from_instance)
        node_from_instance = glm::translate(node_from_instance, part.middle);
    count(drawn, node, *part.rest);
    if (drawn.deformation || part.mesh < 0) {
        drawn.mesh = static_cast<int>(scene.meshes.size());
        scene.meshes.push_back(*part.rest);
        if (!drawn.deformation) part.mesh = drawn.mesh;
    }
    drawn_.push_back(std::move(drawn));
}

void DrawnMeshes::count(const Drawn& drawn, const PlacedNode& node, const scene::Mesh& mesh) {
    const std::size_t instances = drawn.node_from_instance.size();
    const std::size_t shapes = 1 + (drawn.deformation ? drawn.deformation->targets.size() : 0);
    instance_count_.add(instances);
    const std::size_t quads = 2 * mesh.lines.size(); // in which lines are drawn: four vertices each
    vertex_count_.add(instances * shapes * std::max({mesh.positions.size(), mesh.indices.size() / 3, quads}));
    name_size_.add(instances * (node_of(document_, node).name.size() + mesh.name.size()));
}

void DrawnMeshes::require_joints(int skin, const Deformation& deformation) const {
    const std::size_t joints = skins_.at(skin).joints.size();
    const std::uint32_t last = deformation.influences.last_joint();
    if (last >= joints)
        document_.fail(fmt::format("a mesh with /skins/{} follows the joint {}, and the skin has {} joints",
                                   skin, last, joints),
                       "export the file again");
}

std::map<int, std::vector<dmat4>> DrawnMeshes::joints(const std::vector<PlacedNode>& placed,
                                                      glm::dvec3 origin) const {
    std::map<int, std::vector<dmat4>> result;
    if (skins_.empty()) return result;
    std::map<int, dmat4> world_from_joint;
    for (const PlacedNode& node : placed) world_from_joint[node.node] = node.world_from_node;
    std::vector<dmat4> elsewhere; // of all nodes, once one is needed that the scene lacks
    for (const auto& [number, skin] : skins_) {
        for (const int joint : skin.joints) {
            if (world_from_joint.contains(joint)) continue;
            if (elsewhere.empty()) elsewhere = world_from_nodes(document_);
            dmat4& world = world_from_joint[joint] = elsewhere[static_cast<std::size_t>(joint)];
            world[3] -= glm::dvec4(origin, 0.0);
        }
        result[number] = world_from_rest(skin, world_from_joint);
    }
    return result;
}

void DrawnMeshes::append_instances(const Drawn& drawn, const PlacedNode& node, scene::Scene& scene) const {
    const std::string& name = node_of(document_, node).name;
    for (const dmat4& node_from_instance : drawn.node_from_instance)
        scene.instances.push_back({drawn.mesh, mat4(node.world_from_node * node_from_instance), name});
}

std::vector<bool> DrawnMeshes::pose(const std::vector<PlacedNode>& placed, scene::Scene& scene) const {
    std::map<int, std::vector<dmat4>> joints = this->joints(placed, scene.origin);
    // A skeleton that mirrors turns triangles inside out, so the instance does the mirroring.
    std::map<int, mat4> world_from_skinned;
    for (auto& [skin, matrices] : joints) {
        const bool is_mirrored = mirrors(matrices);
        world_from_skinned[skin] = is_mirrored ? mat4(mirror) : mat4(1.0f);
        if (is_mirrored)
            for (dmat4& matrix : matrices) matrix = mirror * matrix;
    }
    scene.instances.clear();
    std::vector<bool> is_visible;
    for (const Drawn& drawn : drawn_) {
        const PlacedNode& node = placed[drawn.placed];
        const tinygltf::Node& source = node_of(document_, node);
        const bool is_skinned = drawn.skin >= 0;
        if (drawn.deformation)
            deform(*drawn.deformation, weights_of(document_, source),
                   is_skinned ? std::span<const dmat4>(joints.at(drawn.skin)) : std::span<const dmat4>{},
                   scene.meshes[static_cast<std::size_t>(drawn.mesh)]);
        if (is_skinned)
            scene.instances.push_back({drawn.mesh, world_from_skinned.at(drawn.skin), source.name});
        else
            append_instances(drawn, node, scene);
        is_visible.resize(scene.instances.size(), node.is_visible);
    }
    return is_visible;
}

} // namespace sr::gltf
