#pragma once
// Emission is a property of surfaces: this finds the emissive surfaces of a scene that are area lights.
#include "scene/scene.hpp"

namespace sr::scene {

/// What the emissive surfaces of a scene amount to.
struct EmissiveSurfaces {
    std::vector<RectangleLight> rectangles;
    /// Names of emissive instances that are seen but light nothing yet, because they are not made of plain
    /// rectangles (any other shape, or an emissive texture).
    std::vector<std::string> not_lights;
};

/// Pairs the triangles of every emissive, untextured mesh into rectangles, in world space. An instance whose
/// triangles do not all pair up (tolerance: a thousandth of an edge) goes to `not_lights` whole.
EmissiveSurfaces emissive_surfaces(const Scene& scene);

} // namespace sr::scene
