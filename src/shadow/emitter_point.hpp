#pragma once
// Points on emitters, the same for a whole picture, to make depth maps from.
#include "scene/light.hpp"

namespace sr::shadow {

/// A point on an emitter, uniform over the area of a flat one. Of a sphere or tube it is one within, as
/// shaders/light/map_sample.glsl has it; of a light with a place and no extent the place.
struct EmitterPoint {
    vec3 place{0.0f};          // [m]; of parallel light: the unit direction towards it
    vec3 normal{0.0f};         // unit, the side on which it shines; zero where it shines in all directions
    float extent = 0.0f;       // of a flat emitter: one over the point's density [m²]
    vec2 uv{0.0f};             // where the emitter's texture is read
    bool is_two_sided = false; // it shines on the other side as well
    bool is_far = false;       // parallel light: `place` is a direction
};

/// Returns whether the light is more than one point or direction, so that its shadows have penumbrae.
bool has_extent(const scene::Light& light);

/// The point that the random numbers u in [0, 1)³ choose. The texture coordinates are those that its map has.
EmitterPoint point_on(const scene::Light& light, vec3 u);

/// A point in the middle of the light, or near it.
EmitterPoint middle_of(const scene::Light& light);

} // namespace sr::shadow
