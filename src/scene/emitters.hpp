#pragma once
// Emission is a property of surfaces: emissive surfaces are area lights.
#include "scene/scene.hpp"

namespace sr::scene {

/// Everything that lights a scene: its lights, then its emissive surfaces in world space. An untextured
/// instance whose triangles all pair up into rectangles (tolerance: a thousandth of an edge) is that many
/// rectangles, any other is one MeshLight.
std::vector<Light> emitters_of(const Scene& scene);

/// The same, and every instance learns which of these lights its surface is.
std::vector<Light> assign_emitters(Scene& scene);

} // namespace sr::scene
