#pragma once
// A mesh, and the box around points.
#include "core/math.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace sr::scene {

/// Triangles, lines or points of one material, in object space. Every non-empty vertex array has
/// positions.size() elements. Lines and points have no area: they are seen, and cast no shadows.
struct Mesh {
    std::string name;
    std::vector<vec3> positions;
    std::vector<vec3> normals; // unit; of triangles never empty (flat where the file had none); 0 where a
                               // line or point has none that can be used
    std::vector<vec4>
        tangents; // xyz unit, w = ±1: bitangent = w * cross(normal, tangent); empty where no normal map
    std::vector<vec2> texcoords[2]; // either may be empty
    std::vector<vec4> colors;       // linear RGBA, multiplies the base colour; may be empty
    std::vector<std::uint32_t>
        indices;                      // three a triangle, counter-clockwise seen from the front; all in range
    std::vector<std::uint32_t> lines; // two a line; all in range; then there are no triangles
    std::vector<std::uint32_t> points; // one a point; all in range; then there are neither
    int material = 0;                  // index into Scene::materials

    bool is_surface() const { return lines.empty() && points.empty(); }
    bool is_empty() const { return indices.empty() && is_surface(); }
};

/// An axis-aligned box in world space; empty while min > max.
struct Bounds {
    vec3 min{std::numeric_limits<float>::infinity()};
    vec3 max{-std::numeric_limits<float>::infinity()};

    bool is_empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    vec3 center() const { return 0.5f * (min + max); }
    float radius() const { return 0.5f * glm::length(max - min); }
    void extend(vec3 point);
};

} // namespace sr::scene
