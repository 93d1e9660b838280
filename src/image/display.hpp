#pragma once
// From scene-referred radiance to a screen: exposure, tone curve, sRGB encoding. Only for screens and 8-bit
// files.
#include "core/math.hpp"
#include "image/image.hpp"

#include <cmath>
#include <span>
#include <string>
#include <string_view>

namespace sr::image {

/// Curve from exposed linear Rec. 709 to linear light of a screen in 0..1; a row of the table in display.cpp.
struct ToneCurve {
    std::string_view name; // also of its function in shaders/display/tone_curve.glsl
    /// Multiplies radiance by `exposure`, then applies the curve and the sRGB encoding.
    Image (*displayed)(const Image& film, float exposure);
};

std::span<const ToneCurve> tone_curves();
const ToneCurve* tone_curve_named(std::string_view name); // null if there is none
const ToneCurve& default_tone_curve();

/// Returns the text of shaders/display/shown_curve.glsl that chooses this curve.
std::string tone_curve_glsl(const ToneCurve& curve);

/// Narkowicz 2015, "ACES Filmic Tone Mapping Curve": a rational fit to ACES' reference rendering, channel by
/// channel. 1 comes out as 0.80; white is reached at about 6.
vec3 aces(vec3 exposed);

/// Khronos 2024, "PBR Neutral Tone Mapper", specification: takes away F90 = 0.04, what a dielectric reflects,
/// keeps base colours as they are up to 0.76 and compresses what is brighter towards white.
vec3 neutral(vec3 exposed);

/// Sobotka 2022, AgX, as fitted by Wrensch 2023, "Minimal AgX Implementation" (6th-degree polynomial, no
/// look): log2 between -12.47 and 4.03 EV, channels mixed before the curve and unmixed behind it.
vec3 agx(vec3 exposed);

/// The factor that exposure by EV100 applies to luminance [cd/m²]: 1 / (1.2 * 2^EV100).
/// Source: Lagarde & de Rousiers 2014, "Moving Frostbite to PBR", section 5.1.2.
float exposure_factor(float ev100);

/// The EV100 that brings the log-average luminance of the lit pixels (covered, finite, above zero) to middle
/// grey (Reinhard et al. 2002, Eq. 1, key 0.18), or a higher one if more than a tenth of them would then
/// exceed 1: dark things in the picture do not burn out the bright ones. 0 for an image without lit pixels.
float auto_ev100(const Image& film);

/// Encodes sRGB after clamping to 0..1.
float srgb_encoded(float linear);

/// A three-channel image in 0..1 ready for an 8-bit file. Non-finite pixels come out magenta.
Image displayed(const Image& film, float ev100, const ToneCurve& curve = default_tone_curve());

/// Decodes sRGB: linear light of a code value, both in 0..1 (IEC 61966-2-1).
inline float linear_of_srgb(float code) {
    return code <= 0.04045f ? code / 12.92f : std::pow((code + 0.055f) / 1.055f, 2.4f);
}

/// Encodes sRGB, the inverse. The argument is in 0..1.
inline float srgb_of_linear(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

} // namespace sr::image
