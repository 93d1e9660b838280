#include "golden_mutants/change.hpp"
#include "golden_mutants/recipes.hpp"
#include "golden_mutants/whole.hpp"

#include <array>
#include <cmath>

namespace sr::testing {
namespace {

using image::Image;

Extent size_in(const Mutant& m) { return {m.reference.width, m.reference.height}; }

Recipe little(Base base, const char* name, const std::function<void(Mutant&)>& change) {
    return {base, name, false, change};
}

Recipe little_render(const char* name, const RenderBase& options) {
    return little(Base::render, name, [options](Mutant& m) { m.test = render_base(size_in(m), options); });
}

Recipe little_interface(const char* name, const InterfaceBase& test, const InterfaceBase& reference = {}) {
    return little(Base::interface, name, [=](Mutant& m) {
        m.test = interface_base(size_in(m), test);
        m.reference = interface_base(size_in(m), reference);
    });
}

/// A rectangle in shares of the frame, of which a corner and the size are rounded to pixels.
struct Part {
    float left, top, width, height;
};

/// `f(x, y)` for each pixel of a part that lies inside.
template<typename Function>
void in_part(const Image& image, Part part, const Function& f) {
    const auto pixels = [](float share, int edge) {
        return static_cast<int>(share * static_cast<float>(edge));
    };
    const int left = pixels(part.left, image.width), top = pixels(part.top, image.height);
    for (int y = top; y < std::min(image.height, top + pixels(part.height, image.height)); ++y)
        for (int x = left; x < std::min(image.width, left + pixels(part.width, image.width)); ++x) f(x, y);
}

/// A part of the picture as another one has it.
void take_part(Image& image, const Image& other, Part part) {
    in_part(image, part, [&](int x, int y) { std::ranges::copy(other.at(x, y), image.at(x, y).begin()); });
}

Recipe part_of(Base base, const char* name, Part part, const std::function<Image(const Image&)>& change) {
    return little(base, name, [=](Mutant& m) { take_part(m.test, change(m.test), part); });
}

constexpr Part floor_part{0.1f, 0.62f, 0.25f, 0.3f}, frame{0.0f, 0.0f, 1.0f, 1.0f};

float smoothed(const Image& image, int x, int y, std::size_t channel) {
    float sum = 0.0f;
    for (int k = 0; k < 9; ++k)
        sum += image.at(std::clamp(x + k % 3 - 1, 0, image.width - 1),
                        std::clamp(y + k / 3 - 1, 0, image.height - 1))[channel];
    return sum / 9.0f;
}

/// value + amount · (value - mean of 3×3): sharper, or smoother where the amount is negative.
Image sharpened(const Image& image, float amount) {
    Image result = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                result.at(x, y)[c] += amount * (image.at(x, y)[c] - smoothed(image, x, y, c));
    return result;
}

/// The median of 3×3 pixels: each value is one of the picture's own.
Image despeckled(const Image& image) {
    Image result = image;
    for (int y = 1; y + 1 < image.height; ++y)
        for (int x = 1; x + 1 < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                std::array<float, 9> values{};
                for (int k = 0; k < 9; ++k)
                    values[static_cast<std::size_t>(k)] = image.at(x + k % 3 - 1, y + k / 3 - 1)[c];
                std::ranges::nth_element(values, values.begin() + 4);
                result.at(x, y)[c] = values[4];
            }
    return result;
}

/// Colour at half the resolution, brightness at the whole one.
Image with_coarse_color(const Image& image) {
    const Image coarse = at_half_resolution(image);
    Image result = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto grey = [](auto p) { return (p[0] + 2.0f * p[1] + p[2]) / 4.0f; };
            const float difference = grey(image.at(x, y)) - grey(coarse.at(x, y));
            for (std::size_t c = 0; c < 3; ++c) result.at(x, y)[c] = coarse.at(x, y)[c] + difference;
        }
    return result;
}

std::function<Image(const Image&)> as_codes(const std::function<Image(const Image&)>& change) {
    return [=](const Image& image) {
        Image result = change(image);
        round_to_codes(result);
        return result;
    };
}

/// A line one pixel wide along a diagonal of the reference, which the test lacks.
void lose_outline(Mutant& m) {
    const int edge = m.reference.height / 4;
    for (int k = 0; k < edge; ++k)
        for (const auto& [x, y] : {std::pair{k, 0}, {k, edge}, {0, k}, {edge, k}}) {
            const auto pixel =
                m.reference.at(m.reference.width / 5 + x, m.reference.height * 3 / 5 + y).first(3);
            for (float& value : pixel) value = 0.5f * value + 0.02f;
        }
}

/// Pixels of the background along an edge of two tiles, at uneven distances: the cracks of a T-junction.
void crack(Mutant& m) {
    int y = m.test.height * 3 / 5;
    for (const int step : {3, 7, 4, 11, 5}) {
        y += step;
        std::ranges::copy(m.reference.at(2, 2).first(3), m.test.at(m.test.width * 2 / 3 + y / 3, y).begin());
    }
}

/// Two surfaces in one place: some pixels of a part are those of a tile beside it.
void fight_for_depth(Mutant& m) {
    Random random(81);
    in_part(m.test, {0.6f, 0.7f, 0.1f, 0.1f}, [&](int x, int y) {
        if (random.uniform() < 0.08f)
            for (float& value : m.test.at(x, y).first(3)) value *= 0.4f;
    });
}

void acne(Mutant& m) {
    in_part(m.test, floor_part, [&](int x, int y) {
        const float factor = 1.0f + 0.02f * std::sin(2.1f * static_cast<float>(x + 2 * y));
        for (float& value : m.test.at(x, y).first(3)) value *= factor;
    });
}

/// Colours times alpha once more, where alpha is a fraction: dark fringes.
void premultiply_twice(Mutant& m) {
    for (std::size_t p = 0; p < m.test.pixels.size(); p += 4)
        if (const float alpha = m.test.pixels[p + 3]; alpha > 0.0f && alpha < 1.0f)
            for (std::size_t c = 0; c < 3; ++c) m.test.pixels[p + c] *= alpha;
}

void glow(Mutant& m) {
    const float x0 = 0.825f * static_cast<float>(m.test.height),
                y0 = 0.12f * static_cast<float>(m.test.height);
    for (int y = 0; y < m.test.height; ++y)
        for (int x = 0; x < m.test.width; ++x) {
            const float distance = std::hypot(static_cast<float>(x) - x0, static_cast<float>(y) - y0);
            for (float& value : m.test.at(x, y).first(3))
                value += 0.02f * std::exp(-8.0f * distance / static_cast<float>(m.test.height));
        }
}

std::vector<Recipe> little_renders() {
    const Base base = Base::render;
    const auto without_samples = [](const Image& i) {
        return render_base({i.width, i.height}, {.supersampling = 1});
    };
    const auto gap = [](int first, int end) {
        return [=](Mutant& m) {
            const Image behind = render_base(size_in(m), {.has_wire = false});
            const int top = m.test.height / 5;
            for (int y = top + first; y < top + end; ++y)
                for (int x = 0; x < m.test.width / 3; ++x)
                    std::ranges::copy(behind.at(x, y), m.test.at(x, y).begin());
        };
    };
    return {little_render("shadow_moved_by_2_pixels", {.shadow_offset = 2.0f}),
            little_render("shadow_moved_by_half_a_pixel", {.shadow_offset = 0.5f}),
            little_render("shadow_leaks_2_percent", {.shadow_leak = 0.02f}),
            little_render("highlight_moved_by_1_pixel", {.gloss_offset = 1.0f}),
            little_render("wire_20_pixels_shorter", {.wire_end = 20}),
            little_render("wire_1_pixel_shorter", {.wire_end = 1}),
            little_render("wire_3_pixels_shorter", {.wire_end = 3}),
            little_render("ball_moved_by_a_tenth_of_a_pixel", {.ball_offset = 0.1f}),
            little(base, "gap_of_1_pixel_in_the_wire", gap(0, 1)),
            little(base, "gap_of_2_pixels_in_the_wire", gap(0, 2)),
            part_of(base, "no_antialiasing_on_the_balls_right", {0.0f, 0.35f, 1.0f, 0.1f}, without_samples),
            part_of(base, "mip_bias", {0.0f, 0.46f, 1.0f, 0.2f},
                    [](const Image& i) { return sharpened(i, -1.0f); }),
            part_of(base, "texture_moved_by_1_pixel", floor_part,
                    [](const Image& i) { return moved(i, 1.0f, 0.0f); }),
            part_of(base, "texture_moved_by_a_quarter_of_a_pixel", floor_part,
                    [](const Image& i) { return moved(i, 0.25f, 0.0f); }),
            part_of(base, "part_2_percent_brighter", {0.3f, 0.7f, 0.06f, 0.06f},
                    [](const Image& i) { return scaled(i, 1.02f); }),
            part_of(base, "dark_in_8_bits", frame,
                    [](const Image& i) {
                        return with_colors(
                            i, [](float v) { return v < 0.06f ? std::round(v * 255.0f) / 255.0f : v; });
                    }),
            part_of(base, "column_repeated", {0.61f, 0.0f, 0.39f, 1.0f},
                    [](const Image& i) {
                        return rearranged(
                            i, [&](int x, int y) { return std::pair(x == i.width * 2 / 3 ? x - 1 : x, y); });
                    }),
            little(base, "outline_missing", lose_outline),
            little(base, "cracks", crack),
            little(base, "fight_for_depth", fight_for_depth),
            little(base, "shadow_acne", acne),
            little(base, "dark_fringes", premultiply_twice),
            little(base, "glow_around_the_lamp", glow),
            little(base, "alpha_without_fractions", [](Mutant& m) {
                for (std::size_t p = 3; p < m.test.pixels.size(); p += 4)
                    m.test.pixels[p] = m.test.pixels[p] > 0.0f ? 1.0f : 0.0f;
            })};
}

std::vector<Recipe> little_photos() {
    const Base base = Base::photo;
    const auto part = [](const char* name, Part where, const std::function<Image(const Image&)>& change) {
        return part_of(Base::photo, name, where, as_codes(change));
    };
    const auto turned = [](const Image& i) {
        return rearranged(
            i, [&](int x, int y) { return std::pair(x, std::min(i.height - 1, y + x * 2 / i.width)); });
    };
    return {part("sharpened", frame, [](const Image& i) { return sharpened(i, 0.4f); }),
            part("smoothed", frame, [](const Image& i) { return sharpened(i, -0.5f); }),
            part("a_part_despeckled", {0.4f, 0.4f, 0.1f, 0.1f}, despeckled),
            part("coarse_colour", frame, with_coarse_color),
            part("moved_by_a_tenth_of_a_pixel", frame, [](const Image& i) { return moved(i, 0.1f, 0.0f); }),
            part("white_balance_2_percent", frame,
                 [](Image i) {
                     for (std::size_t p = 0; p < i.pixels.size(); p += 3) {
                         i.pixels[p] *= 1.02f;
                         i.pixels[p + 2] *= 0.98f;
                     }
                     return i;
                 }),
            part("turned_by_2_pixels", frame, turned),
            part("interlaced", frame,
                 [](const Image& i) {
                     return rearranged(
                         i, [](int x, int y) { return std::pair(y % 2 == 1 && x > 0 ? x - 1 : x, y); });
                 }),
            part("black_lifted_by_3_codes", frame,
                 [](const Image& i) {
                     return with_colors(i, [](float v) { return std::max(v, 23.0f / 255.0f); });
                 }),
            little(base, "soft_spot", [](Mutant& m) {
                for (int v = -6; v <= 6; ++v)
                    for (int u = -6; u <= 6; ++u)
                        for (float& value : m.test.at(m.test.width / 3 + u, m.test.height / 2 + v))
                            value -= 0.03f * std::exp(-static_cast<float>(u * u + v * v) / 12.0f);
                round_to_codes(m.test);
            })};
}

std::vector<Recipe> little_interfaces() {
    const Base base = Base::interface;
    const Part label{0.0f, 0.0f, 1.0f, 1.0f};
    return {little_interface("kerning_by_1_pixel", {.kerned = 2}),
            little_interface("a_glyph_of_the_text_exchanged", {.body = "some moise is on line 1,380"}),
            little_interface("c_for_e_in_the_text", {.body = "some noisc is on line 1,380"}),
            little_interface("comma_period_in_the_text", {.body = "some noise is on line 1.380"}),
            little_interface("letter_o_for_digit_0", {.label = "O"}, {.label = "0"}),
            little_interface("q_for_o", {.label = "Q"}, {.label = "O"}),
            little_interface("icon_8_codes_redder", {.icon = 0.1f + 8.0f / 255.0f}),
            little_interface("badge_moved_by_1_pixel", {.badge_offset = 1}),
            little_interface("badge_lacks_a_pixel", {.badge_pixels = 4}),
            little_interface("corners_cut_by_1_pixel", {.has_round_corners = true}),
            little_interface("corners_filled_by_1_pixel", {}, {.has_round_corners = true}),
            little_interface("caret_missing", {}, {.has_caret = true}),
            part_of(base, "text_moved_by_a_quarter_of_a_pixel", {0.0f, 0.4f, 1.0f, 0.1f},
                    as_codes([](const Image& i) { return moved(i, 0.25f, 0.0f); })),
            part_of(base, "fringes_of_colour", label, [](const Image& i) {
                Image result = i;
                for (int y = 0; y < i.height; ++y)
                    for (int x = 1; x + 1 < i.width; ++x) {
                        result.at(x, y)[0] = (2.0f * i.at(x, y)[0] + i.at(x - 1, y)[0]) / 3.0f;
                        result.at(x, y)[2] = (2.0f * i.at(x, y)[2] + i.at(x + 1, y)[2]) / 3.0f;
                    }
                round_to_codes(result);
                return result;
            })};
}

} // namespace

std::vector<Recipe> wrong_by_little() {
    std::vector<Recipe> list;
    for (auto* family : {little_renders, little_photos, little_interfaces})
        for (Recipe& recipe : family()) list.push_back(std::move(recipe));
    return list;
}

} // namespace sr::testing
