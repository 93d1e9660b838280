#pragma once
// A polygonal light.
#include "scene/lights/emitter.hpp"

#include <array>

namespace sr::scene {

/// A flat convex polygon. Emits the radiance L on the side from which its corners go counter-clockwise.
struct PolygonLight {
    static constexpr std::string_view kind = "polygon";

    std::string name;
    std::vector<vec3> corners; // [m], three or more
    vec3 L{1.0f};              // radiance [cd/m²]
    bool is_two_sided = false;
    bool is_visible = true;

    /// Its size is that of its corners.
    static constexpr std::array<NamedShape<PolygonLight>, 1> shapes{{{"polygon", {}}}};

    /// Returns the fault of the corners of a polygon; empty if they have none. Without a fault they are three
    /// or more, lie in one plane (to 1e-4 of the extent), and go around a convex polygon once.
    static std::string fault_of(const std::vector<glm::dvec3>& corners);

    float area() const; // [m²]
    vec3 normal() const;
    vec3 center() const; // the mean of the corners
    Radiator radiator() const;
    Bounds bounds() const;
    void transform(const Motion& by);
    std::optional<LightSurface> surface() const;
    EmitterPoint sample_point(vec3 u) const;
    EmitterPoint middle() const { return sample_point(vec3(0.5f)); }
};

} // namespace sr::scene
