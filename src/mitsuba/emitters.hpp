#pragma once
// Lights as Mitsuba's emitters.
#include "mitsuba/shapes.hpp"

namespace sr::mitsuba {

/// Writes every light of the scene; emissive surfaces are shapes (shapes.hpp). What cannot be said goes into
/// output.warnings, one line each. @throws Error
void write_emitters(Output& output);

/// Returns whether cameras are not to see emitters. Mitsuba hides all or none.
bool hides_emitters(const scene::Scene& scene);

} // namespace sr::mitsuba
