#include "gltf/read/mesh_instances.hpp"

#include "gltf/read/accessor.hpp"
#include "gltf/read/nodes.hpp"
#include "gltf/tinygltf.hpp"
#include "gltf/warnings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::gltf {

std::vector<std::string> variant_names(const Document& document) {
    std::vector<std::string> names;
    if (const json* variants = extension(document.root, "KHR_materials_variants"))
        for (const json& variant : variants->at("variants")) names.push_back(text_in(variant, "name"));
    return names;
}

std::optional<int> find_variant(const Document& document, std::string_view name) {
    if (name.empty()) return std::nullopt;
    std::vector<std::string> names = variant_names(document);
    const auto found = std::ranges::find(names, name);
    if (found != names.end()) return static_cast<int>(found - names.begin());
    for (std::string& known : names) known = in_quotes(known);
    document.fail(fmt::format("there is no material variant {}", in_quotes(name)),
                  names.empty() ? std::string("name none: the file has none")
                                : fmt::format("choose one of {}", fmt::join(names, ", ")));
}

namespace {

using glm::dmat4;

int mesh_number(const json& node) { return integer_in(node, "mesh", -1); }

std::size_t primitive_count(const Document& document, int mesh) {
    return document.model->meshes[static_cast<std::size_t>(mesh)].primitives.size();
}

/// The material of a primitive in a variant, or without one: an index into the file's materials, negative for
/// glTF's default material.
int material_of(const Document& document, const PrimitivePlace& place, std::optional<int> variant) {
    const json& primitive =
        document.entry("meshes", place.mesh).at("primitives").at(static_cast<std::size_t>(place.primitive));
    const json* extension = variant ? gltf::extension(primitive, "KHR_materials_variants") : nullptr;
    if (extension)
        for (const json& mapping : extension->at("mappings"))
            for (const json& chosen : mapping.at("variants"))
                if (chosen.get<int>() == *variant) return mapping.at("material").get<int>();
    return integer_in(primitive, "material", -1);
}

/// The specification, section 3.7.2.2: a node's weights override its mesh's.
std::vector<double> weights_of(const Document& document, const json& node) {
    const std::vector<double> own = numbers_in(node, "weights");
    return own.empty() ? numbers_in(document.entry("meshes", mesh_number(node)), "weights") : own;
}

/// Returns the number of vertices that a primitive states: primitives may share their accessors.
std::uint64_t vertices_at_least(const Document& document, const PrimitivePlace& place) {
    const auto& mesh = document.model->meshes[static_cast<std::size_t>(place.mesh)];
    const auto& primitive = mesh.primitives[static_cast<std::size_t>(place.primitive)];
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

MeshInstances::MeshInstances(const Document& document, const NodeTree& tree,
                             const std::vector<NodeTransform>& nodes, std::optional<int> variant)
    : document_(document),
      tree_(tree),
      nodes_(nodes),
      variant_(variant),
      made_count_(Limit::vertices, document.name),
      instance_count_(Limit::instances, document.name),
      vertex_count_(Limit::vertices, document.name),
      name_size_(Limit::names, document.name) {
    for (const NodeTransform& node : nodes) {
        const int mesh = mesh_number(*node.source);
        if (mesh >= 0 && std::ranges::find(meshes_, mesh) == meshes_.end()) meshes_.push_back(mesh);
    }
}

void MeshInstances::request_materials(MaterialTable& materials) const {
    for (const int mesh : meshes_)
        for (int p = 0; p < static_cast<int>(primitive_count(document_, mesh)); ++p)
            materials.material(material_of(document_, {mesh, p}, variant_));
}

void MeshInstances::build(MaterialTable& materials, scene::Scene& scene, Warnings& warnings) {
    std::map<int, std::vector<Primitive>> primitives;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const json& node = *nodes_[i].source;
        const int mesh = mesh_number(node), skin = integer_in(node, "skin", -1);
        if (mesh < 0) continue;
        const auto [found, is_new] = primitives.try_emplace(mesh);
        if (is_new) found->second = build_primitives(mesh, materials, scene, warnings);
        if (skin >= 0 && !skins_.contains(skin)) skins_.emplace(skin, parse_skin(document_, skin));
        for (Primitive& primitive : found->second) add(i, primitive, scene, warnings);
    }
    if (instanced_.empty())
        warnings.add("no node of the scene has a mesh with triangles, lines or points",
                     "there is nothing to see");
}

std::vector<MeshInstances::Primitive>
MeshInstances::build_primitives(int mesh, MaterialTable& materials, scene::Scene& scene, Warnings& warnings) {
    std::vector<Primitive> result;
    for (int p = 0; p < static_cast<int>(primitive_count(document_, mesh)); ++p) {
        const PrimitivePlace place{mesh, p};
        const int number = materials.material(material_of(document_, place, variant_));
        const scene::Material& material = scene.materials[static_cast<std::size_t>(number)];
        made_count_.add(vertices_at_least(document_, place));
        auto made = build_mesh(document_, place, material, warnings);
        if (!made || made->is_empty()) continue;
        made->material = number;
        Deformation deformation = build_deformation(document_, place, *made, material, warnings);
        Primitive to;
        const bool keeps_shape = deformation.targets.empty() && deformation.influences.per_vertex == 0;
        if (keeps_shape)
            to.middle = moved_to_middle(*made);
        else
            to.deformation = std::make_shared<const Deformation>(std::move(deformation));
        to.rest = std::make_shared<const scene::Mesh>(static_cast<scene::Mesh&&>(*std::move(made)));
        result.push_back(std::move(to));
    }
    return result;
}

void MeshInstances::add(std::size_t index, Primitive& primitive, scene::Scene& scene, Warnings& warnings) {
    const NodeTransform& node = nodes_[index];
    const int skin = integer_in(*node.source, "skin", -1);
    const bool has_influences = primitive.deformation && primitive.deformation->influences.per_vertex > 0;
    if (skin >= 0 && !has_influences)
        warnings.add("a node has a skin, and its mesh has no joints and weights",
                     "it is shown without the skin");
    InstancedMesh instanced{index, primitive.mesh, has_influences ? skin : -1, nullptr, {dmat4(1.0)}};
    if (primitive.deformation && (instanced.skin >= 0 || !primitive.deformation->targets.empty()))
        instanced.deformation = primitive.deformation;
    if (instanced.skin >= 0)
        require_joints(instanced.skin, *primitive.deformation);
    else
        instanced.node_from_instance = parse_instances(document_, node.node);
    for (dmat4& node_from_instance : instanced.node_from_instance)
        node_from_instance = glm::translate(node_from_instance, primitive.middle);
    count(instanced, node, *primitive.rest);
    if (instanced.deformation || primitive.mesh < 0) {
        instanced.mesh = static_cast<int>(scene.meshes.size());
        scene.meshes.push_back(*primitive.rest);
        if (!instanced.deformation) primitive.mesh = instanced.mesh;
    }
    instanced_.push_back(std::move(instanced));
}

void MeshInstances::count(const InstancedMesh& instanced, const NodeTransform& node,
                          const scene::Mesh& mesh) {
    const std::size_t instances = instanced.node_from_instance.size();
    const std::size_t shapes = 1 + (instanced.deformation ? instanced.deformation->targets.size() : 0);
    instance_count_.add(instances);
    const std::size_t quads = 2 * mesh.lines.size(); // in which lines are drawn: four vertices each
    vertex_count_.add(instances * shapes * std::max({mesh.positions.size(), mesh.indices.size() / 3, quads}));
    name_size_.add(instances * (text_in(*node.source, "name").size() + mesh.name.size()));
}

void MeshInstances::require_joints(int skin, const Deformation& deformation) const {
    const std::size_t joints = skins_.at(skin).joints.size();
    const std::uint32_t last = deformation.influences.last_joint();
    if (last >= joints)
        document_.fail(fmt::format("a mesh with /skins/{} follows the joint {}, and the skin has {} joints",
                                   skin, last, joints),
                       "export the file again");
}

std::map<int, std::vector<dmat4>> MeshInstances::joints(const std::vector<NodeTransform>& nodes,
                                                        glm::dvec3 origin) const {
    std::map<int, std::vector<dmat4>> result;
    if (skins_.empty()) return result;
    std::map<int, dmat4> world_from_joint;
    for (const NodeTransform& node : nodes) world_from_joint[node.node] = node.world_from_node;
    std::vector<dmat4> elsewhere; // of all nodes, once one is needed that the scene lacks
    for (const auto& [number, skin] : skins_) {
        for (const int joint : skin.joints) {
            if (world_from_joint.contains(joint)) continue;
            if (elsewhere.empty()) elsewhere = tree_.world_from_nodes();
            dmat4& world = world_from_joint[joint] = elsewhere[static_cast<std::size_t>(joint)];
            world[3] -= glm::dvec4(origin, 0.0);
        }
        result[number] = world_from_rest(skin, world_from_joint);
    }
    return result;
}

void MeshInstances::append_instances(const InstancedMesh& instanced, const NodeTransform& node,
                                     scene::Scene& scene) const {
    const std::string name = text_in(*node.source, "name");
    for (const dmat4& node_from_instance : instanced.node_from_instance)
        scene.instances.push_back(
            {instanced.mesh, mat4(node.world_from_node * node_from_instance), name, {}, node.node});
}

std::vector<bool> MeshInstances::evaluate(const std::vector<NodeTransform>& nodes,
                                          scene::Scene& scene) const {
    std::map<int, std::vector<dmat4>> joints = this->joints(nodes, scene.origin);
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
    for (const InstancedMesh& instanced : instanced_) {
        const NodeTransform& node = nodes[instanced.node];
        const json& source = *node.source;
        const bool is_skinned = instanced.skin >= 0;
        if (instanced.deformation)
            deform(*instanced.deformation, weights_of(document_, source),
                   is_skinned ? std::span<const dmat4>(joints.at(instanced.skin)) : std::span<const dmat4>{},
                   scene.meshes[static_cast<std::size_t>(instanced.mesh)]);
        if (is_skinned)
            scene.instances.push_back({instanced.mesh,
                                       world_from_skinned.at(instanced.skin),
                                       text_in(source, "name"),
                                       {},
                                       node.node});
        else
            append_instances(instanced, node, scene);
        is_visible.resize(scene.instances.size(), node.is_visible);
    }
    return is_visible;
}

} // namespace sr::gltf
