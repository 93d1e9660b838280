#include "image/display.hpp"

#include "core/error.hpp"
#include "core/luminance.hpp"
#include "core/parallel.hpp"
#include "image/log_table.hpp"
#include "image/srgb.hpp"
#include "image/tone_curve.hpp"

#include <cmath>

namespace sr::image {
namespace {

constexpr vec3 magenta{1.0f, 0.0f, 1.0f};

float srgb_exact(float linear) {
    if (!(linear > 0.0f)) return 0.0f;
    if (linear >= 1.0f) return 1.0f;
    return srgb_of_linear(linear);
}

/// The first three channels; of an image with fewer the first, as grey.
vec3 rgb_of(const float* pixel, int channels) {
    return channels >= 3 ? vec3(pixel[0], pixel[1], pixel[2]) : vec3(pixel[0]);
}

/// `curve` is a template's argument so that it is inlined into the loop over pixels.
template<typename Curve>
Image displayed_through(const Image& film, float factor, Curve curve) {
    static const LogTable srgb(srgb_exact, -9, 0); // below 2^-9 the function is linear
    Image screen(film.width, film.height, 3);
    for_each_row(film.height, [&](int row) {
        const float* from = film.at(0, row).data();
        float* to = screen.at(0, row).data();
        const float* end = to + 3 * static_cast<std::size_t>(film.width);
        for (; to != end; from += film.channels, to += 3) {
            const vec3 L = rgb_of(from, film.channels);
            // One test for three channels: a difference of infinities or NaNs is NaN.
            const float check = (L.r - L.r) + (L.g - L.g) + (L.b - L.b);
            const vec3 light = check == 0.0f ? curve(glm::max(L * factor, 0.0f)) : magenta;
            to[0] = srgb(light.r);
            to[1] = srgb(light.g);
            to[2] = srgb(light.b);
        }
    });
    return screen;
}

} // namespace

float exposure_factor(float ev100) { return 1.0f / (1.2f * std::exp2(ev100)); }

float srgb_encoded(float linear) { return srgb_exact(linear); }

Image displayed(const Image& film, float ev100, ToneCurve curve) {
    const float factor = exposure_factor(ev100);
    switch (curve) {
    case ToneCurve::linear: return displayed_through(film, factor, [](vec3 x) { return x; });
    case ToneCurve::aces: return displayed_through(film, factor, aces);
    case ToneCurve::neutral: return displayed_through(film, factor, neutral);
    case ToneCurve::agx: return displayed_through(film, factor, agx);
    }
    require(false, "every tone curve is listed");
    return film;
}

} // namespace sr::image
