#pragma once
// Luminance as colours that can be read back.
#include "image/image.hpp"

namespace sr::image {

/// The colour of a decade of luminance [cd/m²]: always the same, so that pictures can be compared.
/// Between decades colours are interpolated by the logarithm. As stored in 8-bit files, 0 to 1. README.md has
/// the legend.
struct DecadeColor {
    float luminance; // [cd/m²]
    float r, g, b;
};
inline constexpr DecadeColor luminance_scale[]{
    {1e-3f, 0.00f, 0.00f, 0.00f}, // black: this and less
    {1e-2f, 0.25f, 0.00f, 0.35f}, // purple
    {1e-1f, 0.20f, 0.10f, 0.75f}, // indigo
    {1e0f, 0.00f, 0.45f, 1.00f},  // azure
    {1e1f, 0.00f, 0.80f, 0.80f},  // cyan
    {1e2f, 0.20f, 0.75f, 0.15f},  // green
    {1e3f, 1.00f, 0.90f, 0.10f},  // yellow
    {1e4f, 1.00f, 0.45f, 0.00f},  // orange
    {1e5f, 0.80f, 0.00f, 0.10f},  // red
    {1e6f, 1.00f, 1.00f, 1.00f},  // white: this and more
};

/// The luminance of each pixel's first three channels, by luminance_scale: three channels for an 8-bit file.
/// What is not finite is magenta.
Image luminance_colors(const Image& film);

} // namespace sr::image
