#include "golden_mutants/flips.hpp"
#include "golden_mutants/painting.hpp"

#include <array>

namespace sr::testing {
namespace {

using image::Image;

std::vector<Recipe> flips_of(Base base) {
    const auto flips = [base](const char* name, int count, std::uint32_t seed, bool are_along_rows) {
        return right_image(base, name, [=](Image& image) {
            (are_along_rows ? flip_edges_along_rows(image, count, seed) : flip_edges(image, count, seed));
        });
    };
    return {flips("9_edge_pixels", 9, 81, false), flips("15_edge_pixels_along_rows", 15, 82, true),
            flips("16_edge_pixels", 16, 83, false)};
}

/// Changes `count` places, of `width` by `height` pixels each, by so many codes.
Change dust(int count, int width, int height, std::array<float, 3> codes, std::uint32_t seed) {
    return [=](Image& image) {
        Random random(seed);
        for (int k = 0; k < count; ++k) {
            const int x = 8 + static_cast<int>(random.uniform() * static_cast<float>(image.width - 16));
            const int y = 8 + static_cast<int>(random.uniform() * static_cast<float>(image.height - 16));
            in_rectangle(image, x, y, width, height, [&](auto p, int, int) {
                for (std::size_t c = 0; c < 3; ++c)
                    p[c] += (p[c] > 0.5f ? -code : code) * codes[c]; // towards the middle: no code ends
            });
        }
    };
}

void without_grain(Image& image, int left, int top, int edge) {
    std::array<float, 3> sum{};
    in_rectangle(image, left, top, edge, edge, [&](auto p, int, int) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += p[c];
    });
    const auto count = static_cast<float>(edge * edge);
    in_rectangle(image, left, top, edge, edge, [&](auto p, int, int) {
        for (std::size_t c = 0; c < 3; ++c) p[c] = sum[c] / count;
    });
}

std::vector<Recipe> wrong_single_photos() {
    const Base base = Base::photo;
    return {wrong_image(base, "dust_of_14_codes", dust(12, 1, 1, {14, 14, 14}, 84)),
            wrong_image(base, "red_pixels_of_24_codes", dust(8, 1, 1, {24, 0, 0}, 85)),
            wrong_image(base, "squares_of_4_pixels_and_12_codes", dust(6, 2, 2, {12, 12, 12}, 86)),
            wrong_image(base, "scratch_of_10_codes", dust(1, 40, 1, {10, 10, 10}, 87)),
            wrong_image(base, "hair_of_10_codes", dust(1, 1, 40, {-10, -10, -10}, 88)),
            wrong_image(base, "part_without_grain", [](Image& image) {
                without_grain(image, at_share(image.width, 0.3f), at_share(image.height, 0.2f), 8);
            })};
}

/// The pixels at the corners of a rectangle take the colour beside them.
void cut_corners(Image& image, int left, int top, int width, int height) {
    for (const int x : {left, left + width - 1})
        for (const int y : {top, top + height - 1})
            std::ranges::copy(image.at(x == left ? x - 1 : x + 1, y), image.at(x, y).begin());
}

/// Pixels of a row take the colours above them, at distances of `step` give or take `jitter`.
void uneven_teeth(Image& image, int y, int left, int right, int step, int jitter, std::uint32_t seed) {
    Random random(seed);
    for (int x = left; x < right; x += step) {
        const int at = x + static_cast<int>(random.uniform() * static_cast<float>(2 * jitter + 1)) - jitter;
        std::ranges::copy(image.at(at, y - 1), image.at(at, y).begin());
    }
}

std::vector<Recipe> wrong_single_interfaces() {
    const Base base = Base::interface;
    return {wrong_image(base, "teeth_at_uneven_distances",
                        [](Image& image) { uneven_teeth(image, 84, 18, 98, 11, 2, 91); }),
            wrong_image(base, "teeth_along_a_field",
                        [](Image& image) { uneven_teeth(image, 84, 148, image.width - 16, 10, 2, 92); }),
            wrong_image(base, "corners_of_two_parts_cut",
                        [](Image& image) {
                            cut_corners(image, 12, 84, 90, 30);
                            cut_corners(image, 140, 84, image.width - 152, 30);
                        }),
            wrong_image(base, "corners_cut_and_2_edge_pixels",
                        [](Image& image) {
                            cut_corners(image, 12, 84, 90, 30);
                            flip_edges(image, 2, 93);
                        }),
            wrong_image(base, "dots_of_a_text_swapped", [](Image& image) {
                for (int x = 14; x + 1 < image.width - 16; x += 9) // one pixel of a column of letters
                    std::swap_ranges(image.at(x, 47).begin(), image.at(x, 47).end(),
                                     image.at(x + 1, 47).begin());
            })};
}

} // namespace

std::vector<Recipe> single_pixels() {
    std::vector<Recipe> list;
    for (const Base base : {Base::render, Base::photo, Base::interface})
        for (Recipe& recipe : flips_of(base)) list.push_back(std::move(recipe));
    for (auto* family : {wrong_single_photos, wrong_single_interfaces})
        for (Recipe& recipe : family()) list.push_back(std::move(recipe));
    return list;
}

} // namespace sr::testing
