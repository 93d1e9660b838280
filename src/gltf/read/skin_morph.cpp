#include "gltf/read/skin_morph.hpp"

#include "gltf/read/accessor.hpp"
#include "gltf/read/vertices.hpp"
#include "gltf/tinygltf.hpp"
#include "scene/transform.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace sr::gltf {
namespace {

/// One attribute of a target for all vertices of the primitive; empty where it is absent.
std::vector<vec3> displacements(const Document& document, const std::map<std::string, int>& target,
                                const char* name, std::size_t vertex_count, const PrimitivePlace& place) {
    const auto accessor = attribute(document, target, name, vertex_count, place);
    if (!accessor) return {};
    std::vector<vec3> all = vectors<3>(document, *accessor);
    for (const vec3 v : all)
        if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
            document.fail(fmt::format("{}/targets has a {} that is not finite", place.pointer(), name),
                          "export the file again");
    return all;
}

bool moves(const std::vector<vec3>& displacements, std::uint32_t vertex) {
    return !displacements.empty() && displacements[vertex] != vec3(0.0f);
}

} // namespace

std::vector<MorphTarget> parse_targets(const Document& document, const PrimitivePlace& place,
                                       std::span<const std::uint32_t> sources) {
    const auto& mesh = document.model->meshes[static_cast<std::size_t>(place.mesh)];
    const tinygltf::Primitive& primitive = mesh.primitives[static_cast<std::size_t>(place.primitive)];
    const std::size_t count = count_of(document, primitive.attributes.at("POSITION"));
    std::vector<MorphTarget> targets;
    for (const auto& from : primitive.targets) {
        const std::vector<vec3> positions = displacements(document, from, "POSITION", count, place);
        const std::vector<vec3> normals = displacements(document, from, "NORMAL", count, place);
        const std::vector<vec3> tangents = displacements(document, from, "TANGENT", count, place);
        MorphTarget target;
        for (std::uint32_t v = 0; v < sources.size(); ++v) {
            const std::uint32_t source = sources[v];
            if (!moves(positions, source) && !moves(normals, source) && !moves(tangents, source)) continue;
            target.vertices.push_back(v);
            target.positions.push_back(positions.empty() ? vec3(0.0f) : positions[source]);
            if (!normals.empty()) target.normals.push_back(normals[source]);
            if (!tangents.empty()) target.tangents.push_back(tangents[source]);
        }
        // Indices repeat what the accessors have once.
        document.values_read->add(target.vertices.size() + 3 * target.positions.size()
                                  + 3 * target.normals.size() + 3 * target.tangents.size());
        targets.push_back(std::move(target));
    }
    return targets;
}

namespace {

void append_set(const Document& document, const tinygltf::Primitive& primitive, const PrimitivePlace& place,
                int set, std::vector<std::vector<vec4>>& joints, std::vector<std::vector<vec4>>& weights) {
    const std::size_t count = count_of(document, primitive.attributes.at("POSITION"));
    const std::string joints_name = fmt::format("JOINTS_{}", set);
    const std::string weights_name = fmt::format("WEIGHTS_{}", set);
    const auto joint = attribute(document, primitive.attributes, joints_name.c_str(), count, place);
    const auto weight = attribute(document, primitive.attributes, weights_name.c_str(), count, place);
    if (!joint && !weight) return;
    if (!joint || !weight)
        document.fail(fmt::format("{} has one of {} and {}", place.pointer(), joints_name, weights_name),
                      "give it both, or none");
    joints.push_back(vectors<4>(document, *joint));
    weights.push_back(vectors<4>(document, *weight));
    for (const vec4 w : weights.back())
        if (!(w.x >= 0.0f && w.y >= 0.0f && w.z >= 0.0f && w.w >= 0.0f)
            || !std::isfinite(w.x + w.y + w.z + w.w))
            document.fail(fmt::format("{}/attributes/{} has a weight that is negative or not finite",
                                      place.pointer(), weights_name),
                          export_again);
}

/// Makes the weights of each vertex add up to 1, as integers hardly ever do. @return how many added up to 0
std::size_t normalize(Influences& influences) {
    std::size_t unbound = 0;
    const std::size_t n = influences.per_vertex;
    for (std::size_t first = 0; first < influences.weights.size(); first += n) {
        float* weights = &influences.weights[first];
        float sum = 0.0f;
        for (std::size_t i = 0; i < n; ++i) sum += weights[i];
        if (sum > 0.0f)
            for (std::size_t i = 0; i < n; ++i) weights[i] /= sum;
        else
            weights[0] = 1.0f, ++unbound;
    }
    return unbound;
}

} // namespace

Skin parse_skin(const Document& document, int skin) {
    const SkinSource& source = document.skins[static_cast<std::size_t>(skin)];
    Skin result{source.joints, std::vector<glm::dmat4>(source.joints.size(), glm::dmat4(1.0))};
    const std::string pointer = fmt::format("/skins/{}", skin);
    if (source.joints.empty()) document.fail(pointer + " has no joints", export_again);
    if (source.inverse_bind_matrices < 0) return result;
    if (components_of(document, source.inverse_bind_matrices) != 16)
        document.fail(pointer + "/inverseBindMatrices is no MAT4", export_again);
    const std::vector<float> all = numbers(document, source.inverse_bind_matrices);
    if (all.size() < 16 * result.joints.size())
        document.fail(fmt::format("{} has {} inverseBindMatrices for {} joints", pointer, all.size() / 16,
                                  result.joints.size()),
                      export_again);
    if (!std::ranges::all_of(all, [](float number) { return std::isfinite(number); }))
        document.fail(pointer + "/inverseBindMatrices is not finite", export_again);
    for (std::size_t joint = 0; joint < result.joints.size(); ++joint)
        result.joint_from_mesh_rest[joint] = glm::dmat4(glm::make_mat4(&all[16 * joint]));
    return result;
}

std::vector<glm::dmat4> world_from_rest(const Skin& from, const std::map<int, glm::dmat4>& world_from_node) {
    std::vector<glm::dmat4> matrices;
    for (std::size_t joint = 0; joint < from.joints.size(); ++joint)
        matrices.push_back(world_from_node.at(from.joints[joint]) * from.joint_from_mesh_rest[joint]);
    return matrices;
}

std::uint32_t Influences::last_joint() const {
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < joints.size(); ++i)
        if (weights[i] > 0.0f) last = std::max(last, joints[i]);
    return last;
}

Influences parse_influences(const Document& document, const PrimitivePlace& place,
                            std::span<const std::uint32_t> sources, Warnings& warnings) {
    const auto& mesh = document.model->meshes[static_cast<std::size_t>(place.mesh)];
    const tinygltf::Primitive& primitive = mesh.primitives[static_cast<std::size_t>(place.primitive)];
    std::vector<std::vector<vec4>> joints, weights; // a list a set
    for (std::size_t set = 0; set == joints.size(); ++set)
        append_set(document, primitive, place, static_cast<int>(set), joints, weights);
    Influences result;
    result.per_vertex = 4 * joints.size();
    if (joints.empty()) return result;
    document.values_read->add(2 * sources.size()
                              * result.per_vertex); // indices repeat what accessors have once
    for (const std::uint32_t vertex : sources)
        for (std::size_t set = 0; set < joints.size(); ++set)
            for (int i = 0; i < 4; ++i) {
                const float weight = weights[set][vertex][i];
                const float joint = joints[set][vertex][i];
                const bool is_joint = joint >= 0.0f && joint < 65536.0f; // an unsigned short at most
                if (!is_joint && weight > 0.0f)
                    document.fail(
                        fmt::format("{}/attributes/JOINTS_{} contains {}", place.pointer(), set, joint),
                        export_again);
                result.joints.push_back(is_joint ? static_cast<std::uint32_t>(joint) : 0);
                result.weights.push_back(weight);
            }
    warnings.add("a vertex of a skinned mesh follows no joint", "it follows the first", normalize(result));
    return result;
}

namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;

void morph(const Deformation& deformation, std::span<const double> weights, scene::Mesh& mesh) {
    const std::size_t count = std::min(weights.size(), deformation.targets.size());
    for (std::size_t t = 0; t < count; ++t) {
        const MorphTarget& target = deformation.targets[t];
        const auto weight = static_cast<float>(weights[t]);
        if (weight == 0.0f) continue;
        for (std::size_t i = 0; i < target.vertices.size(); ++i) {
            const std::uint32_t v = target.vertices[i];
            mesh.positions[v] += weight * target.positions[i];
            if (!target.normals.empty() && !mesh.normals.empty())
                mesh.normals[v] += weight * target.normals[i];
            if (!target.tangents.empty() && !mesh.tangents.empty())
                mesh.tangents[v] += vec4(weight * target.tangents[i], 0.0f);
        }
    }
}

/// The inverse transpose times the determinant: finite whatever the matrix is, and on the side to which the
/// triangles turn where it mirrors.
dmat3 cofactors(const dmat3& m) {
    return {glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
}

void skin(const Influences& influences, std::span<const dmat4> joints, scene::Mesh& mesh) {
    const std::size_t n = influences.per_vertex;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        dmat4 world_from_rest(0.0);
        for (std::size_t i = v * n; i < (v + 1) * n; ++i)
            if (influences.weights[i] > 0.0f)
                world_from_rest += double{influences.weights[i]} * joints[influences.joints[i]];
        mesh.positions[v] = vec3(world_from_rest * glm::dvec4(mesh.positions[v], 1.0));
        if (mesh.normals.empty()) continue; // points and lines
        const dmat3 linear(world_from_rest);
        mesh.normals[v] = scene::unit_or(cofactors(linear) * dvec3(mesh.normals[v]), vec3(0.0f));
        if (mesh.tangents.empty()) continue;
        const double side = glm::determinant(linear) < 0.0 ? -1.0 : 1.0;
        mesh.tangents[v] = vec4(scene::unit_or(linear * dvec3(mesh.tangents[v]), vec3(0.0f)),
                                mesh.tangents[v].w * static_cast<float>(side));
    }
}

/// Unit, and perpendicular to the normal again, which morphs and skins turn in their own ways.
void straighten_tangents(scene::Mesh& mesh) {
    for (std::size_t v = 0; v < mesh.tangents.size(); ++v) {
        const vec3 normal = mesh.normals[v];
        const vec3 tangent = vec3(mesh.tangents[v]);
        mesh.tangents[v] = vec4(tangent - glm::dot(tangent, normal) * normal, mesh.tangents[v].w);
    }
    repair_tangents(mesh);
}

} // namespace

Deformation build_deformation(const Document& document, const PrimitivePlace& place, const SourcedMesh& mesh,
                              const scene::Material& material, Warnings& warnings) {
    const auto& source = document.model->meshes[static_cast<std::size_t>(place.mesh)];
    const auto& attributes = source.primitives[static_cast<std::size_t>(place.primitive)].attributes;
    Deformation result;
    result.positions = mesh.positions;
    result.normals = mesh.normals;
    result.tangents = mesh.tangents;
    result.targets = parse_targets(document, place, mesh.sources);
    result.influences = parse_influences(document, place, mesh.sources, warnings);
    result.has_flat_normals = !attributes.contains("NORMAL");
    if (!mesh.tangents.empty() && (result.has_flat_normals || !attributes.contains("TANGENT")))
        result.tangents_along = material.normal_texture.texcoord;
    return result;
}

void deform(const Deformation& deformation, std::span<const double> weights, std::span<const dmat4> joints,
            scene::Mesh& mesh) {
    mesh.positions = deformation.positions;
    mesh.normals = deformation.normals;
    mesh.tangents = deformation.tangents;
    morph(deformation, weights, mesh);
    const bool is_skinned = !joints.empty() && deformation.influences.per_vertex > 0;
    if (deformation.has_flat_normals) flatten_normals(mesh);
    // Normals that targets turned are the base of new tangents, so they are unit before and after the skin.
    if (!deformation.targets.empty()) {
        repair_normals(mesh);
        if (deformation.tangents_along) renew_tangents(mesh, *deformation.tangents_along);
    }
    if (is_skinned) {
        skin(deformation.influences, joints, mesh);
        if (deformation.has_flat_normals) flatten_normals(mesh);
        repair_normals(mesh);
    }
    straighten_tangents(mesh);
}

} // namespace sr::gltf
