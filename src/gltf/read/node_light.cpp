#include "gltf/read/node_light.hpp"

#include "scene/lights/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::gltf {

using glm::dvec3;

std::optional<NodeLight> find_light(const Document& document, const NodeTransform& transform,
                                    const char* name) {
    const json& node = *transform.source;
    const json* reference = extension(node, name);
    if (!reference) return std::nullopt;
    const int index = integer_in(*reference, "light", 0);
    const std::string pointer = fmt::format("/extensions/{}/lights/{}", name, index);
    if (document.is_lost(pointer)) return std::nullopt;
    const json& light = document.root.at(json::json_pointer(pointer));
    return NodeLight{node, *reference, light, index,
                     fmt::format("light {} ({})", in_quotes(text_in(light, "name")), pointer)};
}

double max_scale(const NodeTransform& transform) {
    const glm::dmat4& m = transform.world_from_node;
    return std::max({glm::length(dvec3(m[0])), glm::length(dvec3(m[1])), glm::length(dvec3(m[2]))});
}

LightFrame build_frame(const Document& document, const NodeTransform& transform, const std::string& title) {
    const dvec3 y(transform.world_from_node[1]), back(transform.world_from_node[2]);
    if (!(glm::length(back) > 0.0))
        document.fail(
            fmt::format("{} at /nodes/{} is scaled to nothing and so points nowhere", title, transform.node),
            "give its node a scale that is not zero");
    LightFrame frame;
    frame.position = dvec3(transform.world_from_node[3]);
    frame.front = -glm::normalize(back);
    const dvec3 across = glm::cross(y, frame.front);
    // A node that is flat across its light may still aim a spot; only what has a size needs u and v.
    frame.u = glm::length(across) > 0.0 ? glm::normalize(across) : dvec3(0.0);
    frame.v = glm::cross(frame.front, frame.u);
    frame.scale = max_scale(transform);
    return frame;
}

LightFrame build_sided_frame(const Document& document, const NodeTransform& transform,
                             const std::string& title) {
    const LightFrame frame = build_frame(document, transform, title);
    const bool is_flat =
        !(glm::length(frame.u) > 0.0) || !(glm::length(dvec3(transform.world_from_node[0])) > 0.0);
    if (is_flat)
        document.fail(fmt::format("{} at /nodes/{} is scaled to nothing", title, transform.node),
                      "give its node a scale that is not zero");
    return frame;
}

float scaled_size(const Document& document, double size, const LightFrame& frame, std::string_view what,
                  const std::string& title) {
    const auto scaled = static_cast<float>(size * frame.scale);
    if (!(scaled > 0.0f) || !std::isfinite(scaled))
        document.fail(fmt::format("{} has the {} {}", title, what, size), "give a positive one");
    return scaled;
}

std::vector<vec3> parse_corners(const Document& document, const json& list, const glm::dmat4& world_from_node,
                                const std::string& title) {
    std::vector<dvec3> corners;
    for (const json& point : list) {
        const glm::dvec4 local(point[0].get<double>(), point[1].get<double>(), point[2].get<double>(), 1.0);
        corners.emplace_back(world_from_node * local);
    }
    if (glm::determinant(glm::dmat3(world_from_node)) < 0.0) std::reverse(corners.begin(), corners.end());
    const std::string fault = scene::PolygonLight::fault_of(corners);
    if (!fault.empty())
        document.fail(fmt::format("{} {}", title, fault),
                      "give three or more corners around a flat convex polygon");
    std::vector<vec3> result;
    for (const dvec3 corner : corners) {
        result.emplace_back(corner);
        if (!std::isfinite(glm::dot(result.back(), result.back())))
            document.fail(fmt::format("{} stands beyond the range of 32-bit floats", title), "scale it down");
    }
    return result;
}

mat3 world_from_profile(const Document& document, const NodeTransform& transform, const LightFrame& frame,
                        const std::string& title) {
    const dvec3 x(transform.world_from_node[0]), y(transform.world_from_node[1]);
    const dvec3 flat_x = x - glm::dot(x, frame.front) * frame.front;
    if (!(glm::length(flat_x) > 0.0))
        document.fail(fmt::format("{} is scaled to nothing", title),
                      "give its node a scale that is not zero");
    const dvec3 right = glm::normalize(flat_x);
    const dvec3 up = glm::cross(right, frame.front);
    return {vec3(right), vec3(-frame.front), vec3(glm::dot(up, y) < 0.0 ? up : -up)};
}

} // namespace sr::gltf
