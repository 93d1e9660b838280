#pragma once
// A rectangular light.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

/// A flat emitter: the points center + s*half_u + t*half_v for s, t in [-1, 1].
/// It emits the radiance L, the same in all directions on the side of cross(half_u, half_v).
struct RectangleLight {
    static constexpr std::string_view kind = "rectangle";

    std::string name;
    vec3 center{0.0f};             // [m]
    vec3 half_u{1.0f, 0.0f, 0.0f}; // half an edge [m]
    vec3 half_v{0.0f, 1.0f, 0.0f}; // half the other edge [m], perpendicular to half_u
    vec3 L{1.0f};                  // radiance [cd/m²]
    bool is_two_sided = false;
    bool is_visible = true; // false: it lights the scene but the camera does not see it
    EmissionMap map{};
    bool passes_back_faces = false; // see passes_back_faces() in light.hpp

    static constexpr std::array<Dimension<RectangleLight>, 2> sides{
        {{"width", "m", 2.0f, nullptr, &RectangleLight::half_u},
         {"height", "m", 2.0f, nullptr, &RectangleLight::half_v}}};
    static constexpr std::array<NamedShape<RectangleLight>, 1> shapes{{{"rectangle", sides}}};

    std::span<const Dimension<RectangleLight>> sizes() const { return sides; }
    float area() const { return 4.0f * glm::length(glm::cross(half_u, half_v)); } // [m²]
    vec3 normal() const { return glm::normalize(glm::cross(half_u, half_v)); }
    Radiator radiator() const;
    Bounds bounds() const;
    void transform(const Motion& by);
    std::optional<LightSurface> surface() const;
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const { return sample_point(vec3(0.5f)); }
};

} // namespace sr::scene
