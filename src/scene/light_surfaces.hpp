#pragma once
// Area lights are surfaces: cameras see them.
#include "scene/scene.hpp"

namespace sr::scene {

/// Gives every visible light with an extent among scene.lights a surface of its own that emits and does not
/// reflect; not the sun's disk, nor spots and profiles with a radius, whose radiance depends on the
/// direction. Round ones are tessellated, finely enough for a silhouette within 0.03 % of the radius. To be
/// called after assign_emitters, which would take these surfaces for more lights, and whose first lights are
/// scene.lights.
/// @return how many instances were appended to scene.instances
int add_light_surfaces(Scene& scene);

} // namespace sr::scene
