#include "gltf/read/vertices.hpp"

#include "gltf/read/mikktspace.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace sr::gltf {
namespace {

template<typename T>
void gather(std::vector<T>& values, std::span<const std::uint32_t> sources) {
    if (values.empty()) return;
    std::vector<T> gathered;
    gathered.reserve(sources.size());
    for (const std::uint32_t source : sources) gathered.push_back(values[source]);
    values = std::move(gathered);
}

} // namespace

void gather(SourcedMesh& mesh, std::span<const std::uint32_t> sources) {
    gather(mesh.positions, sources);
    gather(mesh.normals, sources);
    gather(mesh.tangents, sources);
    for (auto& texcoords : mesh.texcoords) gather(texcoords, sources);
    gather(mesh.colors, sources);
    gather(mesh.sources, sources);
}

void unweld(SourcedMesh& mesh) {
    gather(mesh, mesh.indices);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
}

void drop_unused(SourcedMesh& mesh) {
    constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> renumbered(mesh.positions.size(), unused);
    std::vector<std::uint32_t> sources;
    for (const std::uint32_t index : mesh.indices) {
        if (renumbered[index] != unused) continue;
        renumbered[index] = static_cast<std::uint32_t>(sources.size());
        sources.push_back(index);
    }
    if (sources.size() == mesh.positions.size()) return;
    for (std::uint32_t& index : mesh.indices) index = renumbered[index];
    gather(mesh, sources);
}

namespace {

using glm::dvec3;

// Twice the area times the normal. In double: products of large or tiny coordinates leave the range of float.
dvec3 area_normal(const scene::Mesh& mesh, std::size_t first_index) {
    const dvec3 a(mesh.positions[mesh.indices[first_index]]);
    const dvec3 b(mesh.positions[mesh.indices[first_index + 1]]);
    const dvec3 c(mesh.positions[mesh.indices[first_index + 2]]);
    return glm::cross(b - a, c - a);
}

vec3 unit_or_z(dvec3 v) {
    const double length = glm::length(v);
    return std::isfinite(length) && length > 0.0 ? vec3(v / length) : vec3(0.0f, 0.0f, 1.0f);
}

bool is_direction(vec3 v) {
    const double square = glm::dot(dvec3(v), dvec3(v));
    return std::isfinite(square) && square > 1e-20;
}

} // namespace

void add_flat_normals(SourcedMesh& mesh) {
    mesh.normals.clear();
    unweld(mesh);
    mesh.normals.resize(mesh.positions.size());
    flatten_normals(mesh);
}

void flatten_normals(scene::Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        mesh.normals[mesh.indices[i]] = mesh.normals[mesh.indices[i + 1]] =
            mesh.normals[mesh.indices[i + 2]] = unit_or_z(area_normal(mesh, i));
}

std::size_t repair_normals(scene::Mesh& mesh) {
    std::size_t bad_count = 0;
    for (vec3& normal : mesh.normals) {
        if (is_direction(normal))
            normal = vec3(glm::normalize(dvec3(normal)));
        else
            ++bad_count, normal = vec3(0.0f);
    }
    if (bad_count == 0 || mesh.indices.empty()) return bad_count; // points and lines have no faces

    std::vector<dvec3> sums(mesh.positions.size(), dvec3(0.0));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const dvec3 normal = area_normal(mesh, i);
        for (std::size_t corner = 0; corner < 3; ++corner) sums[mesh.indices[i + corner]] += normal;
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
        if (mesh.normals[v] == vec3(0.0f)) mesh.normals[v] = unit_or_z(sums[v]);
    return bad_count;
}

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
