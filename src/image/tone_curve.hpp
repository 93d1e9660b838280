#pragma once
// Tone curves: exposed linear Rec. 709 to linear light of a screen in 0..1. Negative values count as 0.
#include "core/math.hpp"

namespace sr::image {

/// Narkowicz 2015, "ACES Filmic Tone Mapping Curve": a rational fit to ACES' reference rendering, channel by
/// channel. 1 comes out as 0.80; white is reached at about 6.
vec3 aces(vec3 exposed);

/// Khronos 2024, "PBR Neutral Tone Mapper", specification: takes away F90 = 0.04, what a dielectric reflects,
/// keeps base colours as they are up to 0.76 and compresses what is brighter towards white.
vec3 neutral(vec3 exposed);

/// Sobotka 2022, AgX, as fitted by Wrensch 2023, "Minimal AgX Implementation" (6th-degree polynomial, no
/// look): log2 between -12.47 and 4.03 EV, channels mixed before the curve and unmixed behind it.
vec3 agx(vec3 exposed);

} // namespace sr::image
