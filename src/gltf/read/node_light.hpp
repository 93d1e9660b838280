#pragma once
// A light that a node has by an extension, and its place, direction and scale.
#include "core/math.hpp"
#include "gltf/document.hpp"
#include "gltf/read/nodes.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::gltf {

/// A light that a node has by an extension.
struct NodeLight {
    const json& node;
    const json& reference; // the extension's object of the node
    const json& light;     // the extension's object of the light
    int index;
    std::string title; // in messages

    std::string name() const { return text_in(text_in(light, "name").empty() ? node : light, "name"); }
};

/// Absent where the node has none, or the light is lost.
std::optional<NodeLight> find_light(const Document& document, const NodeTransform& transform,
                                    const char* name);

/// How a light stands in the world: orthonormal, with one scale.
struct LightFrame {
    glm::dvec3 position{0.0}; // [m]
    glm::dvec3 front{0.0};    // the node's -Z, where the light goes
    glm::dvec3 u{0.0};        // along the node's X or against it, so that cross(u, v) is the front
    glm::dvec3 v{0.0};        // along the node's Y
    double scale = 1.0; // the largest of the node's axes: what the draft of EXT_lights_area scales sizes by
};

/// The longest of the node's axes.
double max_scale(const NodeTransform& transform);

/// @throws Error naming the light if its node is scaled to nothing along its Z
LightFrame build_frame(const Document& document, const NodeTransform& transform, const std::string& title);

/// The same for a light that has sides. @throws Error if they are scaled to nothing, too
LightFrame build_sided_frame(const Document& document, const NodeTransform& transform,
                             const std::string& title);

/// A size in the file times the frame's scale [m]. @throws Error unless it is positive and finite
float scaled_size(const Document& document, double size, const LightFrame& frame, std::string_view what,
                  const std::string& title);

/// To the world from the axes of a profile: its X is the node's, its -Y is the node's -Z, its Z the node's
/// -Y. A node that mirrors mirrors the profile.
mat3 world_from_profile(const Document& document, const NodeTransform& transform, const LightFrame& frame,
                        const std::string& title);

/// A list of [x, y, z] [m] in a node's space, in the world, with the front (from where they go
/// counter-clockwise) kept in front where the node mirrors.
/// @throws Error calling the light `title`, unless they are the corners of a flat convex polygon
std::vector<vec3> parse_corners(const Document& document, const json& list, const glm::dmat4& world_from_node,
                                const std::string& title);

} // namespace sr::gltf
