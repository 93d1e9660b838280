#pragma once
// A ball of every BRDF under one light: shared by the tests and by truth_export, which hands the same scenes
// to Mitsuba.
#include "scene/scene.hpp"

#include <array>
#include <string_view>

namespace sr::truth {

/// One material each, of every model and layer; `brushed` is GGX of two widths, anisotropy_N turned by N
/// degrees, `layers` has all of glTF's layers, and a texture in every slot.
inline constexpr std::array<std::string_view, 17> ball_brdfs{
    "lambert",       "oren_nayar",    "mirror",        "phong",        "blinn_phong", "ggx",
    "brushed",       "conductor",     "merl",          "clearcoat",    "sheen",       "thin_film",
    "anisotropy_00", "anisotropy_30", "anisotropy_90", "plastic_film", "layers"};

/// A mirror shows no point: it has no part in that picture.
inline constexpr std::array<std::string_view, 3> ball_lights{"rectangle", "point", "environment"};
bool is_lit(std::string_view brdf, std::string_view light);

/// Edge of the square picture of a ball [pixels].
inline constexpr int ball_size = 32;

/// A smooth ball of 1 m around the origin, of 4096 triangles, tilted, with tangents and texture coordinates.
/// Its own facets shadow it where light grazes. `brdf` and `light` are of the lists above.
scene::Scene ball_scene(std::string_view brdf, std::string_view light);

/// Orthographic, along -Z.
scene::Camera ball_camera();

/// A BRDF as a measurement would have it: a peak, fibres' sheen and some colour, over difference angles too.
scene::MeasuredBrdf made_measurement();

} // namespace sr::truth
