#include "core/math.hpp"
#include "image/display.hpp"
#include "image/log_table.hpp"
#include "support/address.hpp"

#include <cmath>
#include <limits>

using namespace sr;
using namespace sr::image;
using sr::testing::Test;

namespace {

const ToneCurve& linear_curve = *tone_curve_named("linear");

/// The EV100 at which the exposure factor is 1.
const float ev_of_one = -std::log2(1.2f);

Image uniform(float r, float g, float b, float a = 1.0f) {
    Image image(2, 3, 4);
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        image.pixels[i] = r;
        image.pixels[i + 1] = g;
        image.pixels[i + 2] = b;
        image.pixels[i + 3] = a;
    }
    return image;
}

vec3 shown(vec3 exposed, const ToneCurve& curve) {
    const Image screen = displayed(uniform(exposed.r, exposed.g, exposed.b), ev_of_one, curve);
    const auto pixel = screen.at(1, 2);
    return {pixel[0], pixel[1], pixel[2]};
}

void expect_near(vec3 a, vec3 b, float tolerance) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

const Test luminance_of_white("unit.image.luminance.of_white", [] {
    EXPECT_FLOAT_EQ(luminance(1.0f, 1.0f, 1.0f), 1.0f);
    EXPECT_FLOAT_EQ(luminance(vec3(0.0f, 2.0f, 0.0f)), 2.0f * 0.7152f);
});

const Test exposure_constant("unit.image.display.exposure_constant", [] {
    EXPECT_FLOAT_EQ(exposure_factor(0.0f), 1.0f / 1.2f);
    EXPECT_FLOAT_EQ(exposure_factor(3.0f), 1.0f / 9.6f);
});

const Test auto_exposure_meets_the_key("unit.image.display.auto_exposure_meets_the_key", [] {
    for (const float L : {1e-6f, 0.5f, 40.0f, 1e9f})
        EXPECT_NEAR(L * exposure_factor(auto_ev100(uniform(L, L, L))), 0.18f, 1e-5f) << L;
});

const Test auto_exposure_counts_what_is_lit("unit.image.display.auto_exposure_counts_what_is_lit", [] {
    Image film = uniform(8.0f, 8.0f, 8.0f);
    const float expected = auto_ev100(film);
    film.at(0, 0)[3] = 0.0f;                                     // not covered
    for (std::size_t c = 0; c < 3; ++c) film.at(1, 0)[c] = 0.0f; // black
    film.at(0, 1)[1] = std::numeric_limits<float>::quiet_NaN();  // a hole
    film.at(1, 1)[1] = std::numeric_limits<float>::infinity();
    EXPECT_FLOAT_EQ(auto_ev100(film), expected);
    EXPECT_EQ(auto_ev100(uniform(0.0f, 0.0f, 0.0f)), 0.0f);
    EXPECT_EQ(auto_ev100(uniform(5.0f, 5.0f, 5.0f, 0.0f)), 0.0f);
});

/// Two greys side by side, of which `bright` has the given share of the pixels.
Image two_greys(float dark, float bright, float share) {
    Image film(1000, 4, 3);
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            for (float& value : film.at(x, y))
                value = static_cast<float>(x) < 1000.0f * share ? bright : dark;
    return film;
}

// Within a few stops the log-average alone decides.
const Test auto_exposure_is_the_log_average("unit.image.display.auto_exposure_is_the_log_average", [] {
    const float ev = auto_ev100(two_greys(1.0f, 4.0f, 0.5f)); // log-average 2
    EXPECT_NEAR(2.0f * exposure_factor(ev), 0.18f, 1e-4f);
});

// A bright half over a nearly black one: the average alone would put it at 18.
const Test auto_exposure_spares_highlights("unit.image.display.auto_exposure_spares_highlights", [] {
    const float ev = auto_ev100(two_greys(0.01f, 100.0f, 0.5f));
    EXPECT_NEAR(100.0f * exposure_factor(ev), 1.0f, 0.1f);
    const float lamp = auto_ev100(two_greys(1.0f, 1e6f, 0.04f)); // a small lamp may burn out
    EXPECT_GT(exposure_factor(lamp), 0.05f);
});

const Test srgb_known_values("unit.image.display.srgb_known_values", [] {
    EXPECT_EQ(srgb_encoded(0.0f), 0.0f);
    EXPECT_EQ(srgb_encoded(1.0f), 1.0f);
    EXPECT_EQ(srgb_encoded(-1.0f), 0.0f);
    EXPECT_EQ(srgb_encoded(7.0f), 1.0f);
    EXPECT_EQ(srgb_encoded(std::numeric_limits<float>::quiet_NaN()), 0.0f);
    EXPECT_NEAR(srgb_encoded(0.18f), 0.46136f, 1e-5f);
    EXPECT_NEAR(srgb_encoded(0.0031308f), 0.040449f, 1e-5f);
    EXPECT_NEAR(srgb_encoded(0.5f), 0.73536f, 1e-5f);
});

const Test srgb_round_trip("unit.image.display.srgb_round_trip", [] {
    for (int code = 0; code < 256; ++code) { // each 8-bit code decoded in double and shown again
        const double v = code / 255.0;
        const double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(shown(vec3(static_cast<float>(linear)), linear_curve).g * 255.0f, code, 2e-3f);
    }
});

const Test srgb_table_is_exact_to_8_bits("unit.image.display.srgb_table_is_exact_to_8_bits", [] {
    constexpr int width = 100000;
    Image film(width, 1, 1);
    for (int x = 0; x < width; ++x) film.pixels[static_cast<std::size_t>(x)] = static_cast<float>(x) / width;
    const Image screen = displayed(film, ev_of_one, linear_curve);
    for (int x = 0; x < width; ++x)
        ASSERT_NEAR(screen.at(x, 0)[1], srgb_encoded(film.pixels[static_cast<std::size_t>(x)]), 2e-6f) << x;
});

const Test grey_18("unit.image.display.grey_18", [] {
    expect_near(shown(vec3(0.18f), linear_curve), vec3(0.46136f), 1e-5f);
    // 0.18 * (2.51 * 0.18 + 0.03) / (0.18 * (2.43 * 0.18 + 0.59) + 0.14) = 0.26692
    expect_near(shown(vec3(0.18f), *tone_curve_named("aces")), vec3(srgb_encoded(0.26692f)), 1e-4f);
    expect_near(shown(vec3(0.18f), *tone_curve_named("neutral")), vec3(srgb_encoded(0.14f)), 1e-5f);
    // AgX's curve turns at middle grey, where it is 0.5 (Sobotka 2022); its fit's mean
    // error is 0.002.
    expect_near(glm::pow(agx(vec3(0.18f)), vec3(1.0f / 2.2f)), vec3(0.5f), 0.005f);
});

const Test black_and_white("unit.image.display.black_and_white", [] {
    for (const ToneCurve& curve : tone_curves()) {
        expect_near(shown(vec3(0.0f), curve), vec3(0.0f), 0.003f);
        expect_near(shown(vec3(1e6f), curve), vec3(1.0f), 0.01f);
        expect_near(shown(vec3(-3.0f), curve), shown(vec3(0.0f), curve), 0.0f);
    }
});

const Test curves_are_monotonic("unit.image.display.curves_are_monotonic", [] {
    for (const ToneCurve& curve : tone_curves()) {
        vec3 last(-1.0f);
        for (float ev = -14.0f; ev < 8.0f; ev += 0.05f) {
            const vec3 now = shown(vec3(std::exp2(ev)), curve);
            // AgX's polynomial falls by less than a tenth of an 8-bit step at its black end.
            EXPECT_GE(now.g, last.g - (curve.name == "agx" ? 4e-4f : 0.0f))
                << "curve " << curve.name << " at " << ev << " EV";
            EXPECT_LE(now.g, 1.0f);
            last = now;
        }
    }
});

const Test neutral_keeps_base_colours("unit.image.display.neutral_keeps_base_colours", [] {
    for (const vec3 color : {vec3(0.8f, 0.2f, 0.1f), vec3(0.1f, 0.5f, 0.79f), vec3(0.3f)})
        expect_near(neutral(color), color - 0.04f, 1e-6f);
    expect_near(neutral(vec3(0.04f, 0.5f, 0.5f)), vec3(0.01f, 0.47f, 0.47f), 1e-6f); // x - x²/0.16
    EXPECT_LT(neutral(vec3(1.5f, 1.0f, 1.0f)).r, 1.0f);
});

const Test neutral_loses_colour_at_the_top("unit.image.display.neutral_loses_colour_at_the_top", [] {
    const vec3 bright = neutral(vec3(1000.0f, 100.0f, 100.0f));
    EXPECT_GT(bright.g, 0.98f);
    EXPECT_LE(bright.r, 1.0f);
});

const Test agx_keeps_grey_grey("unit.image.display.agx_keeps_grey_grey", [] {
    for (const float grey : {0.01f, 0.18f, 1.0f, 5.0f}) {
        const vec3 curved = agx(vec3(grey));
        expect_near(curved, vec3(curved.g),
                    1e-3f); // the inset's rows add up to 1 within 2e-4
    }
    const vec3 red = agx(vec3(1.0f, 0.0f, 0.0f));
    EXPECT_GT(red.r, 3.0f * red.g);
});

const Test holes_are_magenta("unit.image.display.holes_are_magenta", [] {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const ToneCurve& curve : tone_curves())
        for (const vec3 hole :
             {vec3(nan, 0.0f, 0.0f), vec3(0.0f, infinity, 0.0f), vec3(0.0f, 0.0f, -infinity)})
            EXPECT_EQ(shown(hole, curve), vec3(1.0f, 0.0f, 1.0f));
});

const Test every_pixel_is_displayed("unit.image.display.every_pixel_is_displayed", [] {
    Image film(5, 7, 3);
    for (std::size_t i = 0; i < film.pixels.size(); ++i) film.pixels[i] = static_cast<float>(i) / 105.0f;
    const Image screen = displayed(film, ev_of_one, linear_curve);
    for (std::size_t i = 0; i < film.pixels.size(); ++i)
        EXPECT_NEAR(screen.pixels[i], srgb_encoded(film.pixels[i]), 2e-6f) << i;
});

const Test names("unit.image.display.names", [] {
    for (const char* name : {"linear", "aces", "neutral", "agx"}) {
        ASSERT_NE(tone_curve_named(name), nullptr) << name;
        EXPECT_EQ(tone_curve_named(name)->name, name);
    }
    EXPECT_EQ(tone_curve_named("filmic"), nullptr);
});

} // namespace
