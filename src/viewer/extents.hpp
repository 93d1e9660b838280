#pragma once
// The sizes of a light that a person can pull, each by itself.
#include "scene/light.hpp"

namespace sr::viewer {

struct Extent {
    const char* name = ""; // as extras.steradian has it: width, height, length, radius
    float size = 0.0f;     // so stated [m]
    vec3 half{0.0f};       // from the centre to the edge [m]; 0: a radius in all directions
};

/// Those of a light; none where only the whole can be scaled (polygons, meshes) or nothing (points without a
/// radius).
std::vector<Extent> extents_of(const scene::Light& light);

/// Whether it is an emitter with an extent, which can be scaled and casts shadows.
bool has_size(const scene::Light& light);

/// Gives extent number `extent` another size, above 0 [m].
void set_size(scene::Light& light, std::size_t extent, float size);

} // namespace sr::viewer
