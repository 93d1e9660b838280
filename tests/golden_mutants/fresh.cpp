#include "golden_mutants/flips.hpp"
#include "golden_mutants/painting.hpp"
#include "golden_mutants/whole.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace sr::testing {
namespace {

using image::Image;

/// The edge of the floor's shadow smoothed over 3×3 pixels, as by a filter that was to remove noise.
void smooth_shadow_edge(Image& image) {
    const Image right = image;
    const auto height = static_cast<float>(image.height);
    for (int y = 1; y + 1 < image.height; ++y)
        for (int x = 1; x + 1 < image.width; ++x) {
            const float u = ((static_cast<float>(x) + 0.5f) / height - 0.45f) / 0.24f,
                        v = ((static_cast<float>(y) + 0.5f) / height - 0.74f) / 0.06f;
            const float distance = std::hypot(u, v);
            if (distance < 0.9f || distance > 1.1f || v < 0.0f) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                float sum = 0.0f;
                for (int k = 0; k < 9; ++k) sum += right.at(x + k % 3 - 1, y + k / 3 - 1)[c];
                image.at(x, y)[c] = sum / 9.0f;
            }
        }
}

/// Values with as many bits behind the leading one in each channel.
void keep_bits(Image& image, std::array<float, 3> bits) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                float& value = image.at(x, y)[c];
                if (value <= 0.0f) continue;
                const float step = std::exp2(std::floor(std::log2(value)) - bits[c]);
                value = std::round(value / step) * step;
            }
}

/// Places where the floor is lit and even, so that its neighbours are alike.
constexpr float floor_x = 0.12f, floor_y = 0.9f;

/// The lamp's first whole pixel in a row.
int lamp_left(const Image& image, int row) {
    int left = 2;
    while (left + 1 < image.width && image.at(left, row)[0] < 39.0f) ++left;
    return left;
}

std::vector<Recipe> fresh_wrong_renders() {
    const Base base = Base::render;
    const auto wrong = [&](const char* name, const Change& change) {
        return wrong_image(base, name, change);
    };
    return {wrong("last_column_black", [](Image& i) { paint(i, i.width - 1, 0, 1, i.height, 0.0f); }),
            wrong("last_row_black", [](Image& i) { paint(i, 0, i.height - 1, i.width, 1, 0.0f); }),
            wrong("corner_pixel_black", [](Image& i) { paint(i, 0, i.height - 1, 1, 1, 0.0f); }),
            wrong("alpha_2_percent_lower",
                  [](Image& i) {
                      for (std::size_t p = 3; p < i.pixels.size(); p += 4) i.pixels[p] *= 0.98f;
                  }),
            wrong("alpha_of_a_pixel",
                  [](Image& i) { i.at(at_share(i.width, floor_x), at_share(i.height, floor_y))[3] = 0.5f; }),
            {base, "depth_infinite_where_nothing_is", false,
             [](Mutant& m) {
                 m.test = m.reference = layered_render_base(extent(m.reference));
                 for (std::size_t p = 10; p < m.test.pixels.size(); p += 11)
                     if (m.test.pixels[p] == 0.0f) m.test.pixels[p] = std::numeric_limits<float>::infinity();
             }},
            wrong("stored_in_11_and_10_bits",
                  [](Image& i) {
                      keep_bits(i, {6.0f, 6.0f, 5.0f});
                  }),
            wrong("gamma_1.01", [](Image& i) { i = with_gamma(i, 1.01f); }),
            wrong("0.7_percent_brighter", [](Image& i) { i = scaled(i, 1.007f); }),
            wrong("red_0.7_percent_brighter",
                  [](Image& i) {
                      in_rectangle(i, 0, 0, i.width, i.height, [](auto p, int, int) { p[0] *= 1.007f; });
                  }),
            wrong("shadow_edge_smoothed", smooth_shadow_edge),
            wrong("lamp_1_pixel_narrower",
                  [](Image& i) {
                      const int left = lamp_left(i, at_share(i.height, 0.12f));
                      for (int y = 0; y < i.height / 5; ++y)
                          std::ranges::copy(i.at(left - 2, y), i.at(left, y).begin());
                  }),
            wrong("horizon_lowered_on_6_pixels",
                  [](Image& i) {
                      const int row = at_share(i.height, 0.45f) + 1;
                      for (int k = 0; k < 6; ++k)
                          std::ranges::copy(i.at(20 + k, row - 3), i.at(20 + k, row).begin());
                  }),
            wrong("two_rows_exchanged",
                  [](Image& i) {
                      const int row = at_share(i.height, 0.8f);
                      for (int x = 0; x < i.width; ++x)
                          std::ranges::swap_ranges(i.at(x, row), i.at(x, row + 1));
                  }),
            wrong("pixel_15_percent_brighter",
                  [](Image& i) {
                      in_rectangle(i, at_share(i.width, floor_x), at_share(i.height, floor_y), 1, 1,
                                   [](auto p, int, int) {
                                       for (float& v : p) v *= 1.15f;
                                   });
                  }),
            wrong("rougher_ball_by_2_percent",
                  [](Image& i) { i = render_base(extent(i), {.roughness = 0.1225f}); })};
}

/// `count` pixels of the last row that take the value to their right, where an edge ends at the border.
void flip_at_the_border(Image& image, int count) {
    const Image right = image;
    const int row = image.height - 1;
    const auto is_like = [](auto a, auto b) { return std::abs(a[1] - b[1]) <= 0.05f * std::max(a[1], b[1]); };
    for (int x = 2, last = -8; x + 2 < image.width && count > 0; ++x) {
        const auto here = right.at(x, row), beside = right.at(x + 1, row);
        if (x < last + 8 || is_like(here, beside) || !is_like(here, right.at(x - 1, row))) continue;
        if (!is_like(here, right.at(x, row - 1)) || !is_like(beside, right.at(x + 2, row))) continue;
        std::ranges::copy(beside, image.at(x, row).begin());
        last = x;
        --count;
    }
}

/// Three pixels beside the lamp take its radiance.
void flip_at_the_lamp(Image& image) {
    for (const float share : {0.1f, 0.12f, 0.14f}) {
        const int row = at_share(image.height, share);
        const int left = lamp_left(image, row);
        std::ranges::copy(image.at(left, row), image.at(left - 1, row).begin());
    }
}

std::vector<Recipe> fresh_right_renders() {
    const Base base = Base::render;
    const auto right = [&](const char* name, const Change& change) {
        return right_image(base, name, change);
    };
    return {right("ball_moved_by_a_256th_of_a_pixel",
                  [](Image& i) { i = render_base(extent(i), {.ball_offset = 1.0f / 256.0f}); }),
            right("shadow_moved_by_a_256th_of_a_pixel",
                  [](Image& i) { i = render_base(extent(i), {.shadow_offset = 1.0f / 256.0f}); }),
            right("5_edge_pixels_along_rows", [](Image& i) { flip_edges_along_rows(i, 5, 81); }),
            right("3_edge_pixels_at_the_border", [](Image& i) { flip_at_the_border(i, 3); }),
            right("0.2_percent_here_and_there",
                  [](Image& i) {
                      Random random(82);
                      i = with_colors(
                          i, [&](float v) { return v * (1.0f + 0.004f * (random.uniform() - 0.5f)); });
                  }),
            right("3_edge_pixels_of_the_lamp", flip_at_the_lamp),
            {base, "tiny_values_flushed_to_0", true,
             [](Mutant& m) {
                 paint(m.reference, 0, 0, m.reference.width / 4, m.reference.height / 4, 1e-9f);
                 m.test = m.reference;
                 paint(m.test, 0, 0, m.test.width / 4, m.test.height / 4, 0.0f);
             },
             ""},
            right("names_in_lower_case", [](Image& i) {
                i.channel_names = {"r", "g", "b", "a"};
            })};
}

void quantise_blocks(Image& image) {
    for (int top = 0; top + 8 <= image.height; top += 8)
        for (int left = 0; left + 8 <= image.width; left += 8)
            for (std::size_t c = 0; c < 3; ++c) {
                float mean = 0.0f;
                in_rectangle(image, left, top, 8, 8, [&](auto p, int, int) { mean += p[c] / 64.0f; });
                const float moved = std::round(mean / (8.0f * code)) * 8.0f * code - mean;
                in_rectangle(image, left, top, 8, 8, [&](auto p, int, int) { p[c] += moved; });
            }
}

std::vector<Recipe> fresh_wrong_photos() {
    const auto wrong = [](const char* name, const Change& change) {
        return wrong_image(Base::photo, name, change);
    };
    return {
        wrong("blocks_of_strong_compression", quantise_blocks),
        wrong("dust",
              [](Image& i) {
                  for (int k = 0; k < 5; ++k)
                      add_to(i, i.width * (k + 1) / 7, i.height * (2 * k % 5 + 1) / 7, 1, 1, -25.0f * code);
              }),
        wrong("hot_pixel", [](Image& i) { i.at(i.width / 3, i.height * 2 / 3)[0] += 60.0f * code; }),
        wrong("rows_3_codes_up_and_down",
              [](Image& i) {
                  in_rectangle(i, i.width / 2, i.height / 4, 24, 24, [](auto p, int, int y) {
                      for (float& v : p) v += (y % 2 == 0 ? 3.0f : -3.0f) * code;
                  });
              }),
        wrong("saturation_30_percent",
              [](Image& i) {
                  in_rectangle(i, 0, 0, i.width, i.height, [](auto p, int, int) {
                      const float mean = (p[0] + p[1] + p[2]) / 3.0f;
                      for (float& v : p) v = mean + 1.3f * (v - mean);
                  });
              }),
        wrong("watermark",
              [](Image& i) {
                  in_rectangle(i, i.width / 2, i.height / 2, 60, 20, [](auto p, int x, int y) {
                      if ((x + y) % 16 < 2)
                          for (float& v : p) v += 4.0f * code;
                  });
              }),
        wrong("banding_in_a_part",
              [](Image& i) {
                  in_rectangle(i, i.width / 3, i.height / 3, i.width / 4, i.height / 4, [](auto p, int, int) {
                      for (float& v : p) v = std::round(v / (8.0f * code)) * 8.0f * code;
                  });
              }),
        wrong("hair",
              [](Image& i) {
                  for (int k = 0; k < 60; ++k)
                      add_to(i, i.width / 2 + k, i.height / 2 + static_cast<int>(12.0 * std::sin(0.08 * k)),
                             1, 1, -12.0f * code);
              }),
        wrong("first_column_black", [](Image& i) { paint(i, 0, 0, 1, i.height, 0.0f); })};
}

/// Harmless to any picture of codes.
std::vector<Recipe> fresh_right_codes(Base base) {
    return {right_image(base, "5_edge_pixels_along_rows", [](Image& i) { flip_edges_along_rows(i, 5, 83); }),
            right_image(base, "rounded_down",
                        [](Image& i) {
                            Random random(84);
                            for (float& v : i.pixels) v -= random.uniform() < 0.5f ? code : 0.0f;
                        }),
            {base, "8_bits_of_16", true,
             [](Mutant& m) {
                 Random random(85);
                 for (float& v : m.reference.pixels)
                     v = std::clamp(v + code * (random.uniform() - 0.5f), 0.0f, 1.0f);
             },
             ""}};
}

constexpr float ink = 26.0f / 255.0f;

void put_tick(Image& image, bool is_mirrored, float value) {
    for (const auto& [x, y] : {std::pair{0, 2}, {1, 3}, {2, 4}, {3, 3}, {4, 2}, {5, 1}, {6, 0}})
        paint(image, 120 + (is_mirrored ? 6 - x : x), 96 + y, 1, 1, value);
}

void put_box(Image& image) {
    paint(image, image.width - 60, 44, 9, 9, ink);
    paint(image, image.width - 59, 45, 7, 7, 1.0f);
}

void put_dashes(Image& image, int from) {
    for (int x = from; x + 4 < image.width - 12; x += 8) paint(image, x, 76, 4, 1, 0.5f);
}

void put_thumb(Image& image, int top) { paint(image, image.width - 6, top, 4, 40, 0.6f); }

void put_soft_shadow(Image& image) {
    for (int k = 0; k < 6; ++k) add_to(image, 14, 118 + k, 88, 1, -static_cast<float>(12 - 2 * k) * code);
}

std::vector<Recipe> fresh_wrong_interfaces() {
    const Base base = Base::interface;
    const auto wrong = [&](const char* name, const Change& change) {
        return wrong_image(base, name, change);
    };
    const auto drawn = [&](const char* name, const InterfaceBase& options) {
        return wrong(name, [options](Image& i) { i = interface_base(extent(i), options); });
    };
    const auto rule_end = [](const Image& i) { return 12 + std::min(800, i.width - 24); };
    return {
        wrong("rule_1_pixel_longer", [=](Image& i) { paint(i, rule_end(i), 70, 1, 1, 0.7f); }),
        wrong("rule_1_pixel_shorter", [=](Image& i) { paint(i, rule_end(i) - 1, 70, 1, 1, 0.97f); }),
        wrong_beside(
            base, "bar_1_pixel_longer", [](Image& i) { paint(i, 12, 76, 90, 4, 0.3f); },
            [](Image& i) { paint(i, 102, 76, 1, 4, 0.3f); }),
        drawn("l_for_i_in_the_text", {.body = "some nolse is on line 1,380"}),
        drawn("letter_o_in_the_amount", {.amount = "1,38O.00"}),
        wrong("text_5_codes_lighter",
              [](Image& i) {
                  in_rectangle(i, 0, 128, i.width, i.height, [](auto p, int, int) {
                      for (float& v : p) v += 5.0f * code * (0.97f - v) / 0.87f;
                  });
              }),
        wrong("amount_struck_through", [](Image& i) { paint(i, 100, 51, 96, 1, ink); }),
        wrong("tick_mirrored",
              [](Image& i) {
                  put_tick(i, false, 0.97f);
                  put_tick(i, true, ink);
              }),
        wrong_beside(base, "box_ticked", put_box, [](Image& i) { paint(i, i.width - 57, 47, 3, 3, ink); }),
        {base, "dashes_moved_by_1_pixel", false,
         [](Mutant& m) {
             put_dashes(m.reference, 12);
             put_dashes(m.test, 13);
         }},
        {base, "thumb_moved_by_1_pixel", false,
         [](Mutant& m) {
             put_thumb(m.reference, 60);
             put_thumb(m.test, 61);
         }},
        {base, "soft_shadow_missing", false, [](Mutant& m) { put_soft_shadow(m.reference); }},
        wrong("word_selected", [](Image& i) {
            in_rectangle(i, 60, 44, 30, 16, [](auto p, int, int) {
                if (p[0] > 0.9f) p[0] -= 4.0f * code;
            });
        })};
}

} // namespace

std::vector<Recipe> fresh_recipes() {
    std::vector<Recipe> list;
    for (auto* family :
         {fresh_wrong_renders, fresh_right_renders, fresh_wrong_photos, fresh_wrong_interfaces})
        for (Recipe& recipe : family()) list.push_back(std::move(recipe));
    for (const Base base : {Base::photo, Base::interface})
        for (Recipe& recipe : fresh_right_codes(base)) list.push_back(std::move(recipe));
    return list;
}

} // namespace sr::testing
