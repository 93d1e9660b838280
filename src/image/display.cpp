#include "image/display.hpp"

#include "core/math.hpp"
#include "core/parallel.hpp"
#include "image/log_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

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
template<vec3 (*curve)(vec3)>
Image displayed_through(const Image& film, float factor) {
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

// AgX's inset and outset, by columns (Wrensch 2023): each is the other's inverse.
constexpr mat3 agx_inset{0.842479062253094f,  0.0423282422610123f, 0.0423756549057051f,
                         0.0784335999999992f, 0.878468636469772f,  0.0784336f,
                         0.0792237451477643f, 0.0791661274605434f, 0.879142973793104f};
constexpr mat3 agx_outset{1.19687900512017f,    -0.0528968517574562f, -0.0529716355144438f,
                          -0.0980208811401368f, 1.15190312990417f,    -0.0980434501171241f,
                          -0.0990297440797205f, -0.0989611768448433f, 1.15107367264116f};
constexpr float agx_min_ev = -12.47393f;
constexpr float agx_max_ev = 4.026069f;

/// AgX's sigmoid over log2 of a channel; its value is encoded for display with the exponent 2.2.
float agx_contrast(float value) {
    const float ev = std::clamp(std::log2(std::max(value, 1e-10f)), agx_min_ev, agx_max_ev);
    const float x = (ev - agx_min_ev) / (agx_max_ev - agx_min_ev);
    // Wrensch 2023, 6th degree, mean squared error 3.67e-6. (Its 7th degree fits better on the whole, but
    // ends at 0.982: white would be grey.)
    const float y =
        (((((15.5f * x - 40.14f) * x + 31.96f) * x - 6.868f) * x + 0.4298f) * x + 0.1191f) * x - 0.00232f;
    return std::clamp(y, 0.0f, 1.0f);
}

vec3 linear(vec3 exposed) { return exposed; }

} // namespace

vec3 aces(vec3 exposed) {
    const vec3 x = glm::max(exposed, 0.0f);
    return glm::clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

vec3 neutral(vec3 exposed) {
    constexpr float f90 = 0.04f;
    constexpr float k_s = 0.8f - f90; // where compression starts
    constexpr float k_d = 0.15f;      // how fast highlights lose their colour
    const vec3 c = glm::max(exposed, 0.0f);
    const float x = std::min({c.r, c.g, c.b});
    const float f = x <= 2.0f * f90 ? x - x * x / (4.0f * f90) : f90;
    const float p = std::max({c.r, c.g, c.b}) - f;
    if (p <= k_s) return c - f;
    const float p_n = 1.0f - (1.0f - k_s) * (1.0f - k_s) / (p + 1.0f - 2.0f * k_s);
    const float g = 1.0f / (k_d * (p - p_n) + 1.0f);
    return (c - f) * (p_n / p) * g + vec3(p_n * (1.0f - g));
}

vec3 agx(vec3 exposed) {
    static const LogTable contrast(agx_contrast, -13, 5); // log2 and the polynomial
    static const LogTable decode([](float x) { return std::pow(x, 2.2f); }, -10, 0);
    const vec3 inset = agx_inset * glm::max(exposed, 0.0f);
    const vec3 curved{contrast(inset.r), contrast(inset.g), contrast(inset.b)};
    const vec3 outset = glm::clamp(agx_outset * curved, 0.0f, 1.0f);
    return {decode(outset.r), decode(outset.g), decode(outset.b)};
}

namespace {

constexpr std::array curves{
    ToneCurve{"linear", displayed_through<linear>}, ToneCurve{"aces", displayed_through<aces>},
    ToneCurve{"neutral", displayed_through<neutral>}, ToneCurve{"agx", displayed_through<agx>}};

} // namespace

std::span<const ToneCurve> tone_curves() { return curves; }

const ToneCurve* tone_curve_named(std::string_view name) {
    const auto found = std::ranges::find(curves, name, &ToneCurve::name);
    return found == curves.end() ? nullptr : &*found;
}

const ToneCurve& default_tone_curve() { return *tone_curve_named("neutral"); }

std::string tone_curve_glsl(const ToneCurve& curve) {
    return fmt::format("#include \"display/tone_curve.glsl\"\n"
                       "vec3 shown_curve(vec3 exposed) {{ return {}(exposed); }}\n",
                       curve.name);
}

float exposure_factor(float ev100) { return 1.0f / (1.2f * std::exp2(ev100)); }

float srgb_encoded(float linear) { return srgb_exact(linear); }

Image displayed(const Image& film, float ev100, const ToneCurve& curve) {
    return curve.displayed(film, exposure_factor(ev100));
}

} // namespace sr::image
