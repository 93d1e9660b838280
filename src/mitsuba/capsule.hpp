#pragma once
// A tube with round ends as triangles.
#include "mitsuba/triangles.hpp"
#include "scene/light.hpp"

namespace sr::mitsuba {

/// The capsule, 192 corners around, with exactly its surface. The mean projected area of a convex body is a
/// quarter of its surface (Cauchy 1832), so that the flux through any large sphere is right too; the outline
/// is off by 10⁻⁴ of the radius.
Triangles capsule(const scene::TubeLight& light);

} // namespace sr::mitsuba
