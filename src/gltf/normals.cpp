#include "gltf/normals.hpp"

#include <cmath>

namespace sr::gltf {
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

} // namespace sr::gltf
