#include "golden_mutants/unforeseen.hpp"
#include "compare/noise_of_seeds.hpp"
#include "golden_mutants/flips.hpp"
#include "golden_mutants/noisy.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace sr::testing {
namespace {

using image::Image;

constexpr Base lit = Base::render;

/// The square around the ball, in pixels.
struct Square {
    int left, top, edge;
};

Square ball_of(const Image& image) {
    return {at_share(image.height, 0.34f), at_share(image.height, 0.34f), at_share(image.height, 0.42f)};
}

/// `f(colours, u, v)` of the ball; u and v are in units of its radius, to the right and below.
template<typename Function>
void on_ball(Image& image, const Function& f) {
    const Square square = ball_of(image);
    const float height = static_cast<float>(image.height);
    in_rectangle(image, square.left, square.top, square.edge, square.edge, [&](auto p, int x, int y) {
        const float u = ((static_cast<float>(x) + 0.5f) / height - 0.55f) / 0.2f;
        const float v = ((static_cast<float>(y) + 0.5f) / height - 0.55f) / 0.2f;
        if (u * u + v * v < 1.0f) f(p, u, v);
    });
}

void scale(std::span<float> values, float factor) {
    for (float& value : values) value *= factor;
}

/// A rectangle that is read `dx`, `dy` away, between pixels.
void move_part(Image& image, int left, int top, int width, int height, float dx, float dy) {
    const Image whole = moved(image, dx, dy);
    in_rectangle(image, left, top, width, height,
                 [&](auto p, int x, int y) { std::ranges::copy(whole.at(x, y).first(3), p.begin()); });
}

/// Rows from the middle on stand one row too low.
void lower_half_by_a_row(Image& image) {
    const Image right = image;
    for (int y = at_share(image.height, 0.62f); y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) std::ranges::copy(right.at(x, y - 1), image.at(x, y).begin());
}

/// The highlight of the key light does not reach its peak.
void clip_highlight(Image& image) {
    float peak = 0.0f;
    on_ball(image, [&](auto p, float, float) { peak = std::max(peak, p[1]); });
    on_ball(image, [&](auto p, float, float) {
        if (p[1] > 0.9f * peak) scale(p, 0.9f * peak / p[1]);
    });
}

void transpose_square(Image& image, int left, int top, int edge) {
    const Image right = image;
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            std::ranges::copy(right.at(left + y, top + x), image.at(left + x, top + y).begin());
}

void mirror_ball(Image& image) {
    const Image right = image;
    const float height = static_cast<float>(image.height);
    on_ball(image, [&](auto p, float u, float v) {
        const int x = static_cast<int>((0.55f - 0.2f * u) * height),
                  y = static_cast<int>((0.55f + 0.2f * v) * height);
        std::ranges::copy(right.at(x, y).first(3), p.begin());
    });
}

/// The floor below the horizon as one sample a pixel sees it.
void alias_horizon(Image& image) {
    const Image one = render_base(extent(image), {.supersampling = 1});
    for (int y = at_share(image.height, 0.46f); y < at_share(image.height, 0.56f); ++y)
        for (int x = 0; x < image.width; ++x) std::ranges::copy(one.at(x, y), image.at(x, y).begin());
}

void spread_alpha(Image& image) {
    const Image right = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 1; x + 1 < image.width; ++x)
            image.at(x, y)[3] = std::max({right.at(x - 1, y)[3], right.at(x, y)[3], right.at(x + 1, y)[3]});
}

/// A wire in the air, brighter than the sky's gradient behind it.
void put_thread(Image& image, float contrast) {
    in_rectangle(image, at_share(image.width, 0.2f), at_share(image.height, 0.3f),
                 at_share(image.width, 0.15f), 1,
                 [contrast](auto p, int, int) { scale(p, 1.0f + contrast); });
}

void put_acne(Image& image) {
    Random random(91);
    in_rectangle(image, at_share(image.width, 0.1f), at_share(image.height, 0.8f), 24, 24,
                 [&](auto p, int, int) {
                     if (random.uniform() < 0.05f) scale(p, 0.7f);
                 });
}

/// Each second wire of a doubled geometry.
void double_wire(Image& image) {
    const Image other = render_base(extent(image), {.wire_offset = 3});
    const Image none = render_base(extent(image), {.has_wire = false});
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (other.at(x, y)[0] != none.at(x, y)[0])
                std::ranges::copy(other.at(x, y), image.at(x, y).begin());
}

void smear_floor(Image& image) {
    const Image right = image;
    for (int y = at_share(image.height, 0.5f); y < at_share(image.height, 0.56f); ++y)
        for (int x = 1; x + 1 < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                image.at(x, y)[c] =
                    (right.at(x - 1, y)[c] + right.at(x, y)[c] + right.at(x + 1, y)[c]) / 3.0f;
}

std::vector<Recipe> wrong_on_the_ball() {
    const auto wrong = [](const char* name, const Change& change) { return wrong_image(lit, name, change); };
    return {wrong("ball_shaded_2_percent_across",
                  [](Image& i) { on_ball(i, [](auto p, float u, float) { scale(p, 1.0f + 0.02f * u); }); }),
            wrong("limb_5_percent_darker",
                  [](Image& i) {
                      on_ball(i, [](auto p, float u, float v) {
                          if (u * u + v * v > 0.9f) scale(p, 0.95f);
                      });
                  }),
            wrong("highlight_clipped", clip_highlight), wrong("ball_mirrored", mirror_ball),
            wrong("ball_redder_in_its_lower_half", [](Image& i) {
                on_ball(i, [](auto p, float, float v) { p[0] *= v > 0.0f ? 1.02f : 1.0f; });
            })};
}

std::vector<Recipe> wrong_in_tiles() {
    const auto wrong = [](const char* name, const Change& change) { return wrong_image(lit, name, change); };
    const auto floor_left = [](const Image& i) { return at_share(i.width, 0.1f); };
    const auto floor_top = [](const Image& i) { return at_share(i.height, 0.78f); };
    const auto limb_left = [](const Image& i) { return at_share(i.height, 0.38f) - 12; };
    const auto limb_top = [](const Image& i) { return at_share(i.height, 0.44f) - 12; };
    return {wrong("lower_half_by_a_row", lower_half_by_a_row),
            wrong("tile_1.5_percent_brighter",
                  [=](Image& i) {
                      in_rectangle(i, floor_left(i), floor_top(i), 32, 32,
                                   [](auto p, int, int) { scale(p, 1.015f); });
                  }),
            wrong("tile_with_red_and_blue_exchanged",
                  [=](Image& i) {
                      in_rectangle(i, floor_left(i), floor_top(i), 16, 16,
                                   [](auto p, int, int) { std::swap(p[0], p[2]); });
                  }),
            wrong("tile_transposed", [=](Image& i) { transpose_square(i, limb_left(i), limb_top(i), 24); }),
            wrong("tile_moved_by_a_quarter_of_a_pixel",
                  [=](Image& i) { move_part(i, limb_left(i), limb_top(i), 24, 24, 0.25f, 0.0f); }),
            wrong("tile_from_a_row_below",
                  [=](Image& i) { move_part(i, limb_left(i), limb_top(i), 24, 24, 0.0f, -1.0f); }),
            wrong("every_64th_pixel_doubled",
                  [](Image& i) {
                      for (int y = 40; y < i.height; y += 64)
                          for (int x = 40; x < i.width; x += 64) scale(i.at(x, y).first(3), 2.0f);
                  }),
            wrong("checkerboard_of_1.5_percent", [](Image& i) {
                in_rectangle(i, 0, 0, i.width, i.height,
                             [](auto p, int x, int y) { scale(p, (x + y) % 2 == 0 ? 1.015f : 0.985f); });
            })};
}

std::vector<Recipe> wrong_elsewhere() {
    const auto wrong = [](const char* name, const Change& change) { return wrong_image(lit, name, change); };
    const auto lamp_pixel = [](Image& i) {
        return i.at(at_share(i.height, 0.82f), at_share(i.height, 0.12f));
    };
    return {wrong("horizon_aliased", alias_horizon),
            wrong("floor_smeared", smear_floor),
            wrong_beside(
                lit, "thread_missing_in_the_sky", [](Image& i) { put_thread(i, 0.15f); },
                [](Image& i) { put_thread(i, 1.0f / 1.15f - 1.0f); }),
            wrong_beside(
                lit, "thread_at_half_its_contrast", [](Image& i) { put_thread(i, 0.15f); },
                [](Image& i) { put_thread(i, 1.075f / 1.15f - 1.0f); }),
            wrong("acne_in_a_part", put_acne),
            wrong("alpha_grown_by_a_pixel", spread_alpha),
            wrong("lamp_pixel_at_half", [=](Image& i) { scale(lamp_pixel(i).first(3), 0.5f); }),
            wrong("lamp_pixel_without_blue", [=](Image& i) { lamp_pixel(i)[2] = 0.0f; }),
            wrong("wire_doubled", double_wire),
            wrong("sky_2_percent_bluer",
                  [](Image& i) {
                      in_rectangle(i, 0, 0, i.width / 4, i.height / 4,
                                   [](auto p, int, int) { p[2] *= 1.02f; });
                  }),
            wrong("nan_where_alpha_is_0",
                  [](Image& i) { i.at(2, 2)[1] = std::numeric_limits<float>::quiet_NaN(); })};
}

/// Harmless or not, beside the noise of both images, which `golden noise` knows from 12 seeds.
Recipe noisy_one(const char* name, bool passes, const Change& change) {
    return {lit, name, passes, [=](Mutant& m) {
                const Image floor = noise_floor(m.reference);
                compare::NoiseOfSeeds seeds;
                for (std::uint32_t seed = 201; seed < 213; ++seed) seeds.add(noisy(m.reference, floor, seed));
                const Image errors = seeds.errors();
                m.options.noise = {errors, errors};
                change(m.test);
                m.test = noisy(m.test, floor, 213);
                m.reference = noisy(m.reference, floor, 214);
            }};
}

std::vector<Recipe> beside_noise() {
    return {noisy_one("noise_of_seeds", true, [](Image&) {}),
            noisy_one("noise_of_seeds_and_2_rare_samples", true,
                      [](Image& i) {
                          std::ranges::fill(i.at(i.width / 2, at_share(i.height, 0.9f)).first(3), 4.0f);
                          std::ranges::fill(i.at(i.width / 4, at_share(i.height, 0.8f)).first(3), 4.0f);
                      }),
            noisy_one("noise_of_seeds_and_3_percent", false, [](Image& i) { i = scaled(i, 1.03f); }),
            noisy_one("noise_of_seeds_and_a_part_5_percent_brighter", false,
                      [](Image& i) {
                          in_rectangle(i, at_share(i.width, 0.1f), at_share(i.height, 0.7f), 48, 48,
                                       [](auto p, int, int) { scale(p, 1.05f); });
                      }),
            noisy_one("noise_of_seeds_and_no_object", false,
                      [](Image& i) { i = render_base(extent(i), {.has_object = false}); }),
            noisy_one("noise_of_seeds_and_20_fireflies", false, [](Image& i) {
                Random random(92);
                for (int k = 0; k < 20; ++k)
                    std::ranges::fill(i.at(static_cast<int>(random.uniform() * static_cast<float>(i.width)),
                                           static_cast<int>(random.uniform() * static_cast<float>(i.height)))
                                          .first(3),
                                      20.0f);
            })};
}

std::vector<Recipe> right_renders() {
    const auto right = [](const char* name, const Change& change) { return right_image(lit, name, change); };
    return {right("0.4_percent_across_the_frame",
                  [](Image& i) {
                      const float width = static_cast<float>(i.width);
                      in_rectangle(i, 0, 0, i.width, i.height, [=](auto p, int x, int) {
                          scale(p, 1.0f + 0.004f * static_cast<float>(x) / width);
                      });
                  }),
            right("ordered_dither_of_0.3_percent",
                  [](Image& i) {
                      in_rectangle(i, 0, 0, i.width, i.height, [](auto p, int x, int y) {
                          const int bayer = (x % 2 == y % 2 ? 0 : 2) + y % 2;
                          scale(p, 1.0f + 0.002f * (static_cast<float>(bayer) - 1.5f));
                      });
                  }),
            right("8_edge_pixels_by_half_their_samples", [](Image& i) { flip_edges(i, 8, 93, 0.5f); })};
}

} // namespace

std::vector<Recipe> unforeseen_recipes() {
    std::vector<Recipe> list;
    for (auto* family : {wrong_on_the_ball, wrong_in_tiles, wrong_elsewhere, beside_noise, right_renders,
                         unforeseen_photos, unforeseen_interfaces})
        for (Recipe& recipe : family()) list.push_back(std::move(recipe));
    return list;
}

} // namespace sr::testing
