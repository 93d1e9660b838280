#pragma once
// Both images as a screen would show them: what FLIP and SSIM look at.
#include "golden/planes.hpp"
#include "image/image.hpp"

namespace sr::golden {

/// Images of three channels in 0..1, sRGB-coded.
struct Screens {
    image::Image test;
    image::Image reference;
};

/// Light at the reference's automatic exposure through the Neutral tone curve, so that a factor between the
/// two stays visible; codes for a screen as they are. Both images are finite.
Screens screens(const image::Image& test, const image::Image& reference, bool is_light);

/// A code as linear light of the screen, 0..1 (IEC 61966-2-1), channel by channel.
image::Image screen_light(const image::Image& codes);

/// Luma: the Rec. 709 weights over codes.
Plane luma(const image::Image& codes);

/// The inverse of the sRGB transfer function; values above 1 go on along its curve, negative ones mirror it.
float srgb_decoded(float code);

/// The sRGB transfer function, going on above 1.
float srgb_encoded_unclamped(float linear);

} // namespace sr::golden
