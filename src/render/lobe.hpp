#pragma once
// The BRDF of the surface at a pixel, direction by direction.
#include "render/renderer.hpp"

#include <span>

namespace sr::render {

struct PixelBrdf {
    bool is_mirror = false; // a delta towards reflect(-wo, n): f_r is its reflectance ρ instead
    std::vector<vec3> f_r;  // [1/sr], one for each wi
};

/// f_r(x, wi, wo) for each `wi` (unit, world space) of the surface that the centre of the pixel (column, row)
/// sees, counted from the upper left corner, its textures and normal map included: the fragment that renders
/// there, with another direction each time. Only the pixel's triangle is drawn, so that it takes some 10 µs a
/// direction in software GL.
/// @return absent where nothing is seen. @throws ShaderError, Error
std::optional<PixelBrdf> brdf_at(const GpuScene& scene, const scene::Camera& camera,
                                 const RenderOptions& options, int column, int row, std::span<const vec3> wi);

} // namespace sr::render
