#include "gltf/morph.hpp"

#include "gltf/accessor.hpp"

#include <cmath>
#include <fmt/format.h>

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

std::vector<MorphTarget> targets_of(const Document& document, const PrimitivePlace& place,
                                    std::span<const std::uint32_t> sources) {
    const auto& mesh = document.model.meshes[static_cast<std::size_t>(place.mesh)];
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

} // namespace sr::gltf
