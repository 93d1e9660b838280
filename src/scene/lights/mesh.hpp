#pragma once
// A light that is a set of triangles.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

/// Emissive triangles, each an emitter of its own, taken together.
struct MeshLight {
    static constexpr std::string_view kind = "mesh";

    struct Triangle {
        std::array<vec3, 3> corners; // [m], counter-clockwise seen from the front
        std::array<vec2, 3> uv;      // where a texture is read
    };
    std::string name;
    std::vector<Triangle> triangles; // none without area
    vec3 L{1.0f};                    // radiance [cd/m²], times the texture
    bool is_two_sided = false;
    int texture = -1; // index into Scene::textures; negative: none

    float area() const;  // [m²]
    vec3 center() const; // the mean of all corners
    /// It has no axis, and so no intensity.
    Radiator radiator() const;
    Bounds bounds() const;
    void transform(const Motion& by);
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const { return sample_point(vec3(0.5f)); }
};

} // namespace sr::scene
