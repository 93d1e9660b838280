#include "golden/screen.hpp"

#include "image/display.hpp"
#include "core/luminance.hpp"
#include "image/srgb.hpp"

#include <algorithm>
#include <cmath>

namespace sr::golden {
namespace {

using image::Image;

/// The first three channels, or grey three times, clamped to what a code can be.
Image codes_of(const Image& image) {
    Image codes(image.width, image.height, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                codes.at(x, y)[c] = std::clamp(image.at(x, y)[image.channels < 3 ? 0 : c], 0.0f, 1.0f);
    return codes;
}

} // namespace

Screens screens(const Image& test, const Image& reference, bool is_light) {
    if (!is_light) return {codes_of(test), codes_of(reference)};
    const float ev100 = image::auto_ev100(reference);
    return {image::displayed(test, ev100, image::ToneCurve::neutral),
            image::displayed(reference, ev100, image::ToneCurve::neutral)};
}

Image screen_light(const Image& codes) {
    Image light = codes;
    for (float& value : light.pixels) value = srgb_decoded(value);
    return light;
}

Plane luma(const Image& codes) {
    Plane plane(codes.width, codes.height);
    for (std::size_t i = 0; i < plane.values.size(); ++i)
        plane.values[i] =
            luminance(codes.pixels[3 * i], codes.pixels[3 * i + 1], codes.pixels[3 * i + 2]);
    return plane;
}

float srgb_decoded(float code) { return std::copysign(image::linear_of_srgb(std::abs(code)), code); }

float srgb_encoded_unclamped(float linear) {
    return std::copysign(image::srgb_of_linear(std::abs(linear)), linear);
}

} // namespace sr::golden
