// The window shows the picture that files get.
#include "core/math.hpp"
#include "image/colormap.hpp"
#include "image/display.hpp"
#include "output/variables.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/glsl_table.hpp"
#include "viewer/panels/legend.hpp"
#include "viewer/view/presenter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

std::vector<vec3> radiances() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<vec3> all{vec3(0.0f), vec3(-1.0f, 0.5f, 2.0f), vec3(nan, 0, 0), vec3(0, -infinity, 0)};
    for (float ev = -14.0f; ev < 12.0f; ev += 0.21f)
        for (const vec3 color : {vec3(1.0f), vec3(1.0f, 0.2f, 0.05f), vec3(0.02f, 0.4f, 0.9f)})
            all.push_back(color * std::exp2(ev));
    return all;
}

const Test equals_the_files("unit.viewer.display.equals_the_files", [] {
    sr::testing::context();
    constexpr float ev100 = 1.5f;
    const std::vector<vec3> table = radiances();
    image::Image film(static_cast<int>(table.size()), 1, 3);
    for (std::size_t i = 0; i < table.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) film.pixels[3 * i + c] = table[i][static_cast<int>(c)];
    for (const image::ToneCurve& curve : image::tone_curves()) {
        std::vector<sr::testing::Row> rows;
        for (const vec3 L : table) rows.push_back({vec4(L, image::exposure_factor(ev100))});
        const auto shown = sr::testing::evaluate(
            "#include \"display/displayed.glsl\"\n", "return vec4(displayed(a.rgb, a.w), 1.0);", rows,
            nullptr, {{"display/shown_curve.glsl", image::tone_curve_glsl(curve)}});
        const image::Image expected = image::displayed(film, ev100, curve);
        for (std::size_t i = 0; i < table.size(); ++i)
            for (int c = 0; c < 3; ++c) // a hundredth of an 8-bit step
                EXPECT_NEAR(shown[i][c], expected.at(static_cast<int>(i), 0)[static_cast<std::size_t>(c)],
                            4e-5f)
                    << "curve " << curve.name << ", " << table[i].r << " " << table[i].g << " " << table[i].b;
    }
});

const Test false_colors("unit.viewer.display.false_colours_equal_the_files", [] {
    sr::testing::context();
    for (const image::Decades decades : {image::Decades{}, image::Decades{-1.5f, 2.25f}}) {
        std::vector<sr::testing::Row> rows;
        std::vector<vec3> expected;
        for (float exponent = -6.0f; exponent < 8.0f; exponent += 0.013f) {
            const float L = std::pow(10.0f, exponent);
            rows.push_back({vec4(L, decades.first, decades.last, 0.0f)});
            expected.push_back(image::luminance_color(luminance(vec3(L)), decades));
        }
        const auto shown =
            sr::testing::evaluate("#include \"display/colormap.glsl\"\n",
                                  "return vec4(luminance_color(luminance(vec3(a.x)), a.yz), 1.0);", rows,
                                  nullptr, {{"display/choice.glsl", image::colormap_glsl()}});
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (int c = 0; c < 3; ++c) // a hundredth of an 8-bit step
                EXPECT_NEAR(shown[i][c], expected[i][c], 4e-5f) << rows[i][0].x << " cd/m²";
    }
});

const Test views("unit.viewer.display.views_equal_the_files", [] {
    sr::testing::context();
    image::Image film(24, 1, 4);
    std::vector<sr::testing::Row> rows;
    for (int i = 0; i < film.width; ++i) { // shares, with and without a divisor and coverage
        const float divisor = i % 4 == 0 ? 0.0f : 0.2f * static_cast<float>(i);
        const float coverage = i % 3 == 0 ? 0.0f : 1.0f;
        const vec4 pixel(0.3f * divisor, 0.7f * divisor, divisor, coverage);
        for (int c = 0; c < 4; ++c) film.at(i, 0)[static_cast<std::size_t>(c)] = pixel[c];
        rows.push_back({pixel});
    }
    for (const output::Variable& variable : output::all_variables()) {
        using output::Display;
        if (variable.display != Display::share && variable.display != Display::leaks) continue;
        const auto shown =
            sr::testing::evaluate("#include \"display/view.glsl\"\n", "return vec4(view_color(a), 1.0);",
                                  rows, nullptr, {{"display/choice.glsl", viewer::view_glsl(&variable)}});
        const image::Image expected = output::colors_of(variable, output::numbers_of(variable, film));
        for (int i = 0; i < film.width; ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(shown[static_cast<std::size_t>(i)][c],
                            expected.at(i, 0)[static_cast<std::size_t>(c)], 4e-5f)
                    << variable.name << " at " << i;
    }
});

const Test fits("unit.viewer.legend.a_fitted_range_has_all_but_the_extremes", [] {
    image::Image film(1000, 1, 4); // from 0.01 to 100 cd/m², one pixel far out, some without light
    for (int x = 0; x < film.width; ++x) {
        const float Y = std::pow(10.0f, -2.0f + 4.0f * static_cast<float>(x) / 999.0f);
        for (std::size_t c = 0; c < 3; ++c) film.at(x, 0)[c] = x % 10 == 0 ? 0.0f : Y;
    }
    for (std::size_t c = 0; c < 3; ++c) film.at(501, 0)[c] = 1e7f;
    const auto range = range_of(film);
    ASSERT_TRUE(range.has_value());
    EXPECT_NEAR(range->first, -2.0f, 0.11f);
    EXPECT_NEAR(range->last, 2.0f, 0.11f);
    for (float& value : film.pixels) value = std::min(value, 0.0f);
    EXPECT_FALSE(range_of(film)) << "nothing is lit";
    for (float& value : film.pixels) value = 3.0f;
    const auto even = range_of(film);
    ASSERT_TRUE(even.has_value());
    EXPECT_NEAR(even->last - even->first, 0.5f, 1e-5f) << "one value has a range, too";
});

} // namespace
