#include "gltf/tangents.hpp"

#include "gltf/mikktspace.hpp"
#include "gltf/vertices.hpp"

#include <cmath>
#include <limits>

namespace sr::gltf {
namespace {

// Crossing with the axis that is farthest from the normal.
vec3 perpendicular(vec3 normal) {
    const vec3 axis = std::abs(normal.x) < 0.6f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    return glm::normalize(glm::cross(normal, axis));
}

// A vertex takes the tangent of its first corner; corners that differ get copies, chained so that they are
// reused.
void split_by_tangent(SourcedMesh& mesh, const std::vector<vec4>& corner_tangents) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    const auto vertex_count = static_cast<std::uint32_t>(mesh.positions.size());
    std::vector<std::uint32_t> sources(vertex_count);
    for (std::uint32_t v = 0; v < vertex_count; ++v) sources[v] = v;
    std::vector<std::uint32_t> next_copy(vertex_count, none);
    std::vector<bool> is_taken(vertex_count, false);
    mesh.tangents.assign(vertex_count, vec4(1.0f, 0.0f, 0.0f, 1.0f));

    for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
        const vec4 tangent = corner_tangents[corner];
        std::uint32_t v = mesh.indices[corner];
        if (!is_taken[v]) {
            is_taken[v] = true;
            mesh.tangents[v] = tangent;
        }
        while (mesh.tangents[v] != tangent && next_copy[v] != none) v = next_copy[v];
        if (mesh.tangents[v] != tangent) {
            next_copy[v] = static_cast<std::uint32_t>(sources.size());
            v = next_copy[v];
            sources.push_back(sources[mesh.indices[corner]]);
            next_copy.push_back(none);
            mesh.tangents.push_back(tangent);
        }
        mesh.indices[corner] = v;
    }
    if (sources.size() == vertex_count) return;
    std::vector<vec4> tangents = std::move(mesh.tangents);
    mesh.tangents.clear();
    gather(mesh, sources);
    mesh.tangents = std::move(tangents);
}

} // namespace

void add_tangents(SourcedMesh& mesh, int texcoord_set) {
    const std::vector<vec2>& texcoords = mesh.texcoords[texcoord_set];
    if (texcoords.empty()) {
        mesh.tangents.clear();
        for (const vec3 normal : mesh.normals) mesh.tangents.emplace_back(perpendicular(normal), 1.0f);
        return;
    }
    split_by_tangent(mesh, mikktspace(mesh.positions, mesh.normals, texcoords, mesh.indices));
}

void renew_tangents(scene::Mesh& mesh, int texcoord_set) {
    const std::vector<vec2>& texcoords = mesh.texcoords[texcoord_set];
    if (texcoords.empty()) {
        for (std::size_t v = 0; v < mesh.normals.size(); ++v)
            mesh.tangents[v] = vec4(perpendicular(mesh.normals[v]), 1.0f);
        return;
    }
    const std::vector<vec4> corners = mikktspace(mesh.positions, mesh.normals, texcoords, mesh.indices);
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
        mesh.tangents[mesh.indices[corner]] = corners[corner];
}

std::size_t repair_tangents(scene::Mesh& mesh) {
    std::size_t bad_count = 0;
    for (std::size_t v = 0; v < mesh.tangents.size(); ++v) {
        vec4& tangent = mesh.tangents[v];
        const float length = glm::length(vec3(tangent));
        const vec3 direction = vec3(tangent) / length;
        const float w = tangent.w < 0.0f ? -1.0f : 1.0f;
        const bool is_good = std::isfinite(length) && length > 1e-10f
                             && std::abs(glm::dot(direction, mesh.normals[v])) < 0.9999f;
        if (!is_good) ++bad_count;
        tangent = vec4(is_good ? direction : perpendicular(mesh.normals[v]), w);
    }
    return bad_count;
}

} // namespace sr::gltf
