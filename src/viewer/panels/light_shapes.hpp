#pragma once
// Lights as lines in the picture: outline, direction, cone and range.
#include "viewer/document/light_selection.hpp"
#include "viewer/view/projection.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace sr::viewer {

using Polyline = std::vector<vec3>; // in the scene

struct LightShape {
    std::vector<Polyline> outline;                  // of the emitter
    std::vector<Polyline> reach;                    // cone and range
    std::optional<std::pair<vec3, vec3>> direction; // from the light to where it shines
};

/// `length`: of an arrow, and of a cone without a range [m]. `pivot`: a place for a light that has none.
LightShape shape_of(const scene::Light& light, float length, vec3 pivot, vec3 eye);

/// Draws the selected light with all lines, and the outline of the one under the pointer.
void draw_light_shapes(const LightEditor& lights, const LightSelection& selected,
                       std::optional<std::size_t> hovered, const Projection& projection, float length,
                       vec3 pivot, float scale);

/// The light whose outline is nearest to the pointer, a few pixels away at most; absent if there is none.
std::optional<std::size_t> outline_under(const LightEditor& lights, const Projection& projection,
                                         vec2 pointer);

} // namespace sr::viewer
