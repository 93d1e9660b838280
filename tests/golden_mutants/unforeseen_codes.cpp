#include "core/math.hpp"
#include "golden_mutants/flips.hpp"
#include "golden_mutants/unforeseen.hpp"

#include <array>
#include <cmath>

namespace sr::testing {
namespace {

using image::Image;

using Block = std::array<float, 64>;

/// The discrete cosine transform of 8×8 values (ITU-T T.81, A.3.3), or its inverse.
Block cosines(const Block& block, bool is_inverse) {
    Block result{};
    for (std::size_t to = 0; to < 64; ++to)
        for (std::size_t from = 0; from < 64; ++from) {
            const std::size_t frequency = is_inverse ? from : to, place = is_inverse ? to : from;
            const auto term = [](std::size_t f, std::size_t x) {
                const float angle = static_cast<float>((2 * x + 1) * f) * pi / 16.0f;
                return std::cos(angle) * (f == 0 ? std::sqrt(0.125f) : 0.5f);
            };
            result[to] += block[from] * term(frequency % 8, place % 8) * term(frequency / 8, place / 8);
        }
    return result;
}

/// As JPEG stores it: cosines of 8×8 pixels in steps of codes, which grow with the frequency.
void quantise_cosines(Image& image, float first_step, float growth) {
    for (int top = 0; top + 8 <= image.height; top += 8)
        for (int left = 0; left + 8 <= image.width; left += 8)
            for (std::size_t c = 0; c < 3; ++c) {
                Block block;
                for (int k = 0; k < 64; ++k)
                    block[static_cast<std::size_t>(k)] = image.at(left + k % 8, top + k / 8)[c];
                block = cosines(block, false);
                for (std::size_t f = 0; f < 64; ++f) {
                    const float step = code * (first_step + growth * static_cast<float>(f % 8 + f / 8));
                    block[f] = std::round(block[f] / step) * step;
                }
                block = cosines(block, true);
                for (int k = 0; k < 64; ++k)
                    image.at(left + k % 8, top + k / 8)[c] = block[static_cast<std::size_t>(k)];
            }
}

/// Strong compression of a part of 64×64 pixels.
void compress_part(Image& image, float first_step, float growth) {
    Image part(64, 64, 3);
    const int left = image.width / 4, top = image.height / 4;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) std::ranges::copy(image.at(left + x, top + y), part.at(x, y).begin());
    quantise_cosines(part, first_step, growth);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) std::ranges::copy(part.at(x, y), image.at(left + x, top + y).begin());
}

/// A faint second picture, as of a reflection in a filter.
void add_ghost(Image& image) {
    const Image right = image;
    in_rectangle(image, 40, 0, image.width, image.height, [&](auto p, int x, int y) {
        for (std::size_t c = 0; c < 3; ++c) p[c] = 0.95f * p[c] + 0.05f * right.at(x - 40, y)[c];
    });
}

void move_red(Image& image) {
    const Image other = moved(image, 0.5f, 0.0f);
    in_rectangle(image, 0, 0, image.width, image.height,
                 [&](auto p, int x, int y) { p[0] = other.at(x, y)[0]; });
}

void move_square(Image& image, int left, int top, int edge, float dx, float dy) {
    const Image other = moved(image, dx, dy);
    in_rectangle(image, left, top, edge, edge,
                 [&](auto p, int x, int y) { std::ranges::copy(other.at(x, y), p.begin()); });
}

void stick_bit(Image& image) {
    in_rectangle(image, image.width / 3, image.height / 3, 8, 8, [](auto p, int, int) {
        for (float& v : p) v = static_cast<float>(static_cast<int>(std::round(v / code)) | 16) * code;
    });
}

void add_moire(Image& image) {
    in_rectangle(image, 0, 0, image.width, image.height, [](auto p, int x, int y) {
        for (float& v : p)
            v += 4.0f * code * std::sin(0.9f * static_cast<float>(x) + 0.5f * static_cast<float>(y));
    });
}

void exchange_pixels(Image& image) {
    const int y = image.height / 2;
    for (int x = image.width / 2; x < image.width / 2 + 16; x += 2)
        std::ranges::swap_ranges(image.at(x, y), image.at(x + 1, y));
}

/// Rows that were sent twice: from here on all stand two rows lower.
void insert_rows(Image& image) {
    const Image right = image;
    for (int y = image.height * 3 / 4; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) std::ranges::copy(right.at(x, y - 2), image.at(x, y).begin());
}

Change each(void (*change)(std::span<float>, int, int)) {
    return [change](Image& i) {
        in_rectangle(i, 0, 0, i.width, i.height, [change](auto p, int x, int y) { change(p, x, y); });
    };
}

void add_to_all(std::span<float> values, float amount) {
    for (float& value : values) value += amount;
}

std::vector<Recipe> right_codes(Base base) {
    const auto right = [base](const char* name, const Change& change) {
        return right_image(base, name, change);
    };
    return {right("dithered_by_a_code",
                  each([](auto p, int x, int y) { add_to_all(p, (x + y) % 2 == 0 ? code : -code); })),
            right("finest_compression", [](Image& i) { quantise_cosines(i, 1.0f, 0.0f); }),
            right("6_edge_pixels_by_half", [](Image& i) { flip_edges(i, 6, 94, 0.5f); })};
}

/// A button whose shade changes from above to below.
void put_gradient(Image& image, float codes) {
    in_rectangle(image, 140, 84, 60, 30, [codes](auto p, int, int y) {
        for (float& v : p) v = 0.6f + codes * code * static_cast<float>(y - 84);
    });
}

void put_radio(Image& image, int dot) {
    paint(image, 204, 40, 12, 12, 0.6f);
    paint(image, 205, 41, 10, 10, 1.0f);
    paint(image, 208, 44, dot, dot, 0.2f);
}

/// Dots of a menu, 2×2 pixels.
void put_menu(Image& image, int dots) {
    for (int k = 0; k < dots; ++k) paint(image, image.width - 40, 8 + 5 * k, 2, 2, 0.97f);
}

void colour_a_word(Image& image) {
    in_rectangle(image, 12, 128, 50, 16, [](auto p, int, int) {
        if (p[0] < 0.9f) p[2] = std::min(1.0f, p[2] + 0.5f);
    });
}

void lower_a_line(Image& image) {
    const Image right = image;
    for (int y = 145; y < 160; ++y)
        for (int x = 0; x < image.width; ++x) std::ranges::copy(right.at(x, y - 1), image.at(x, y).begin());
}

void thicken_text(Image& image) {
    in_rectangle(image, 0, 128, image.width, image.height, [](auto p, int, int) {
        for (float& v : p) v = 0.97f * std::pow(std::max(v, 0.0f) / 0.97f, 1.15f);
    });
}

} // namespace

std::vector<Recipe> unforeseen_photos() {
    const auto wrong = [](const char* name, const Change& change) {
        return wrong_image(Base::photo, name, change);
    };
    std::vector<Recipe> list{
        wrong("compressed", [](Image& i) { quantise_cosines(i, 4.0f, 2.0f); }),
        wrong("a_part_compressed", [](Image& i) { compress_part(i, 4.0f, 2.0f); }),
        wrong("ghost", add_ghost),
        wrong("red_moved_by_half_a_pixel", move_red),
        wrong("a_part_moved_by_a_quarter_of_a_pixel",
              [](Image& i) { move_square(i, i.width / 3, i.height / 2, 40, 0.25f, 0.25f); }),
        wrong("bit_stuck_in_a_block", stick_bit),
        wrong("moire", add_moire),
        wrong("pixels_exchanged_in_a_row", exchange_pixels),
        wrong("two_rows_inserted", insert_rows),
        wrong("every_8th_column_4_codes_brighter",
              each([](auto p, int x, int) { add_to_all(p, x % 8 == 0 ? 4.0f * code : 0.0f); })),
        wrong("shadows_4_codes_redder",
              each([](auto p, int, int) { p[0] += p[1] < 0.25f ? 4.0f * code : 0.0f; })),
        wrong("seam_of_two_columns", [](Image& i) {
            for (int y = 0; y < i.height; ++y) std::ranges::copy(i.at(63, y), i.at(64, y).begin());
        })};
    for (Recipe& recipe : right_codes(Base::photo)) list.push_back(std::move(recipe));
    return list;
}

std::vector<Recipe> unforeseen_interfaces() {
    const auto wrong = [](const char* name, const Change& change) {
        return wrong_image(Base::interface, name, change);
    };
    const auto drawn = [](const char* name, const InterfaceBase& test, const InterfaceBase& reference) {
        return Recipe{Base::interface, name, false, [=](Mutant& m) {
                          m.test = interface_base(extent(m.reference), test);
                          m.reference = interface_base(extent(m.reference), reference);
                      }};
    };
    std::vector<Recipe> list{
        drawn("save_sane_in_small_letters", {.label = "Sane", .text_size = 1.25f}, {.text_size = 1.25f}),
        drawn("digit_3_8_in_large_letters", {.amount = "1,880.00", .text_size = 2.6f}, {.text_size = 2.6f}),
        drawn("comma_period_in_the_smallest_letters", {.amount = "1.380.00", .text_size = 1.0f},
              {.text_size = 1.0f}),
        wrong_beside(
            Base::interface, "button_flat", [](Image& i) { put_gradient(i, -0.5f); },
            [](Image& i) { paint(i, 140, 84, 60, 30, 0.6f - 7.0f * code); }),
        wrong_beside(
            Base::interface, "line_on_a_gradient", [](Image& i) { put_gradient(i, -1.0f); },
            [](Image& i) { add_to(i, 144, 98, 40, 1, 6.0f * code); }),
        wrong_beside(
            Base::interface, "radio_off", [](Image& i) { put_radio(i, 4); },
            [](Image& i) { put_radio(i, 0); }),
        wrong_beside(
            Base::interface, "radio_dot_a_pixel_smaller", [](Image& i) { put_radio(i, 4); },
            [](Image& i) { put_radio(i, 3); }),
        wrong_beside(
            Base::interface, "menu_lacks_a_dot", [](Image& i) { put_menu(i, 3); },
            [](Image& i) { paint(i, i.width - 40, 18, 2, 2, i.at(i.width - 44, 18)[0]); }),
        wrong("word_in_another_colour", colour_a_word),
        wrong("line_of_text_a_pixel_lower", lower_a_line),
        wrong("text_thicker", thicken_text),
        wrong("a_part_compressed", [](Image& i) { compress_part(i, 4.0f, 2.0f); }),
        wrong("field_with_a_border", [](Image& i) { add_to(i, 140, 84, i.width - 152, 1, -8.0f * code); }),
        wrong("two_rows_inserted", insert_rows)};
    for (Recipe& recipe : right_codes(Base::interface)) list.push_back(std::move(recipe));
    return list;
}

} // namespace sr::testing
