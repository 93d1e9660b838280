#include "gltf/deformation.hpp"

#include "gltf/normals.hpp"
#include "gltf/tangents.hpp"
#include "scene/transform.hpp"

#include <algorithm>

namespace sr::gltf {
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

Deformation deformation_of(const Document& document, const PrimitivePlace& place, const SourcedMesh& mesh,
                           const scene::Material& material, Warnings& warnings) {
    const auto& source = document.model.meshes[static_cast<std::size_t>(place.mesh)];
    const auto& attributes = source.primitives[static_cast<std::size_t>(place.primitive)].attributes;
    Deformation result;
    result.positions = mesh.positions;
    result.normals = mesh.normals;
    result.tangents = mesh.tangents;
    result.targets = targets_of(document, place, mesh.sources);
    result.influences = influences_of(document, place, mesh.sources, warnings);
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
