#pragma once
// Emission is a property of surfaces: emissive surfaces are area lights, and area lights are surfaces.
#include "scene/scene.hpp"

namespace sr::scene {

/// Everything that lights a scene.
struct Emitters {
    /// The file's lights, then a rectangle for every rectangle that its emissive surfaces are made of.
    std::vector<Light> lights;
    /// Names of emissive instances that are seen but light nothing yet, because they are not made of plain
    /// rectangles (any other shape, or an emissive texture).
    std::vector<std::string> seen_only;
};

/// Pairs the triangles of every emissive, untextured mesh into rectangles, in world space. An instance whose
/// triangles do not all pair up (tolerance: a thousandth of an edge) goes to `seen_only` whole.
Emitters emitters_of(const Scene& scene);

/// Gives every visible rectangle among scene.lights a surface of its own that emits and does not reflect, so
/// that cameras see it. To be called after emitters_of, which would take these surfaces for more lights.
void add_light_surfaces(Scene& scene);

} // namespace sr::scene
