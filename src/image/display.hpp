#pragma once
// From scene-referred radiance to a screen: exposure, tone curve, sRGB encoding. Only for screens and 8-bit
// files.
#include "core/named.hpp"
#include "image/image.hpp"

#include <array>

namespace sr::image {

enum class ToneCurve { linear, aces, neutral, agx };

inline constexpr std::array<Named<ToneCurve>, 4> tone_curves{{{"linear", ToneCurve::linear},
                                                              {"aces", ToneCurve::aces},
                                                              {"neutral", ToneCurve::neutral},
                                                              {"agx", ToneCurve::agx}}};

/// The factor that exposure by EV100 applies to luminance [cd/m²]: 1 / (1.2 * 2^EV100).
/// Source: Lagarde & de Rousiers 2014, "Moving Frostbite to PBR", section 5.1.2.
float exposure_factor(float ev100);

/// The EV100 that brings the log-average luminance of the lit pixels (covered, finite, above zero) to middle
/// grey (Reinhard et al. 2002, Eq. 1, key 0.18), or a higher one if more than a tenth of them would then
/// exceed 1: dark things in the picture do not burn out the bright ones. 0 for an image without lit pixels.
float auto_ev100(const Image& film);

/// The sRGB transfer function, IEC 61966-2-1. Clamps to 0..1.
float srgb_encoded(float linear);

/// A three-channel image in 0..1 ready for an 8-bit file. Non-finite pixels come out magenta.
Image displayed(const Image& film, float ev100, ToneCurve curve);

} // namespace sr::image
