#pragma once
// The sRGB curve between code values and linear light, both 0..1 (IEC 61966-2-1).
#include <cmath>

namespace sr::image {

inline float linear_of_srgb(float code) {
    return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

inline float srgb_of_linear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

} // namespace sr::image
