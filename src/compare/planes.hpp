#pragma once
// Planes (single channels) and their convolution, and images as a screen shows them: the input of FLIP and
// SSIM.
#include "image/image.hpp"

#include <functional>
#include <vector>

namespace sr::compare {

/// One channel, rows from top to bottom.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int plane_width, int plane_height)
        : width(plane_width),
          height(plane_height),
          values(static_cast<std::size_t>(plane_width) * static_cast<std::size_t>(plane_height)) {}
};

/// The mean over all pixels.
double mean(const Plane& plane);

/// A kernel of 2 radius + 1 values.
using Kernel = std::vector<float>;

/// Samples `f` at -radius … radius.
Kernel sample_kernel(int radius, const std::function<double(double)>& f);

/// Convolves the rows with `horizontal`, then the columns with `vertical`. Border pixels repeat outside.
Plane convolve(const Plane& plane, const Kernel& horizontal, const Kernel& vertical);

/// Two images of three channels in 0..1, sRGB-coded.
struct DisplayedImages {
    image::Image test;
    image::Image reference;
};

/// Displays light at the reference's automatic exposure through the Neutral tone curve, so that a factor
/// between the two stays visible. Code values stay as they are. Both images are finite.
DisplayedImages display(const image::Image& test, const image::Image& reference, bool is_light);

/// Decodes code values to linear light of the screen in 0..1 (IEC 61966-2-1), channel by channel.
image::Image screen_light(const image::Image& codes);

/// Luma: the Rec. 709 weights over code values.
Plane luma(const image::Image& codes);

/// The inverse of the sRGB transfer function, odd in its argument and continued above 1.
float srgb_decoded(float code);

/// The sRGB transfer function, odd in its argument and continued above 1.
float srgb_encoded_unclamped(float linear);

} // namespace sr::compare
