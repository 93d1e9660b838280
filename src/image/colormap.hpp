#pragma once
// The colour map of luminance and of errors: viridis.
#include "image/image.hpp"

#include "core/math.hpp"

#include <array>
#include <string>

namespace sr::image {

namespace detail {
constexpr vec3 code_values(int hex) {
    return vec3(static_cast<float>(hex >> 16), static_cast<float>(hex >> 8 & 255),
                static_cast<float>(hex & 255))
           / 255.0f;
}
} // namespace detail

/// Viridis (Smith & van der Walt 2015) at ten equal steps, as sRGB code values from 0 to 1. Its lightness
/// rises evenly, so that it also reads in grey and with colour blindness.
inline constexpr std::array viridis{detail::code_values(0x440154), detail::code_values(0x482878),
                                    detail::code_values(0x3e4a89), detail::code_values(0x31688e),
                                    detail::code_values(0x26828e), detail::code_values(0x1f9e89),
                                    detail::code_values(0x35b779), detail::code_values(0x6dcd59),
                                    detail::code_values(0xb4de2c), detail::code_values(0xfde725)};

/// The colour of what has no value on the map: magenta.
inline constexpr vec3 nonfinite_color{1.0f, 0.0f, 1.0f};

/// Returns the colour at `place`, clamped to 0 to 1, by linear interpolation of `viridis`.
vec3 colormap(float place);

/// Returns `viridis` as a GLSL constant, `const vec3 colormap_colors[10]`, for shaders/display/colormap.glsl.
std::string colormap_glsl();

/// The luminances that the map covers, as powers of ten [cd/m²]. By default each decade ends at one of
/// `viridis`.
struct Decades {
    float first = -3.0f;
    float last = 6.0f;
};

/// Returns the colour of a luminance [cd/m²] on a logarithmic scale; `nonfinite_color` if it is not finite.
vec3 luminance_color(float luminance, const Decades& decades = {});

/// Returns the luminance of each pixel's first three channels on the default scale: three channels for an
/// 8-bit file.
Image luminance_colors(const Image& film);

} // namespace sr::image
