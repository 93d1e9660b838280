#include "gltf/skin.hpp"

#include "gltf/accessor.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/type_ptr.hpp>

namespace sr::gltf {
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

Skin skin_of(const Document& document, int skin) {
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

Influences influences_of(const Document& document, const PrimitivePlace& place,
                         std::span<const std::uint32_t> sources, Warnings& warnings) {
    const auto& mesh = document.model.meshes[static_cast<std::size_t>(place.mesh)];
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

} // namespace sr::gltf
