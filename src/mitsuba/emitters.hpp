#pragma once
// Lights as Mitsuba's emitters.
#include "mitsuba/shapes.hpp"

namespace sr::mitsuba {

/// Writes every light of the scene; emissive surfaces are shapes (shapes.hpp). What cannot be said goes into
/// output.warnings, one line each. @throws Error
void write_emitters(Output& output);

/// Returns whether cameras are not to see emitters. Mitsuba hides all or none.
bool hides_emitters(const scene::Scene& scene);

/// Tessellates a tube, 192 corners around, with exactly its surface. The mean projected area of a convex body
/// is a quarter of its surface (Cauchy 1832), so that the flux through any large sphere is right too; the
/// outline is off by 10⁻⁴ of the radius.
Triangles capsule(const scene::TubeLight& light);

} // namespace sr::mitsuba
