#include "golden_mutants/change.hpp"
#include "golden_mutants/mutants.hpp"
#include "golden_mutants/picture.hpp"

#include <utility>

namespace sr::testing {
namespace {

using image::Image;

Image shifted(const Image& image, int dx, int dy) {
    return rearranged(image, [=](int x, int y) { return std::pair{x - dx, y - dy}; });
}

/// Each pixel the mean of itself and its eight neighbours.
Image blurred(const Image& image) {
    Image result = image;
    for (int y = 1; y + 1 < image.height; ++y)
        for (int x = 1; x + 1 < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                float sum = 0.0f;
                for (int k = 0; k < 9; ++k) sum += image.at(x + k % 3 - 1, y + k / 3 - 1)[c];
                result.at(x, y)[c] = sum / 9.0f;
            }
    return result;
}

/// A picture higher than wide, turned on its side.
Mutant turned() {
    const Image right = picture_of_sphere({.width = 64, .height = 96});
    Image test(96, 64, right.channels);
    test.channel_names = right.channel_names;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 96; ++x) std::ranges::copy(right.at(y, 95 - x), test.at(x, y).begin());
    return {"turned_by_90", test, right, false, "rotated_90", {}, {}};
}

} // namespace

std::vector<Mutant> wrong_places() {
    const Image right = picture_of_sphere();
    const int last = right.width - 1;
    const auto moved = [&](const char* name, const char* diagnosis, auto where) {
        return Mutant{name, rearranged(right, where), right, false, diagnosis, {}, {}};
    };
    std::vector<Mutant> list{moved("flipped_x", "flipped_x",
                                   [=](int x, int y) {
                                       return std::pair{last - x, y};
                                   }),
                             moved("flipped_y", "flipped_y",
                                   [=](int x, int y) {
                                       return std::pair{x, last - y};
                                   }),
                             moved("turned_by_180", "rotated_180",
                                   [=](int x, int y) {
                                       return std::pair{last - x, last - y};
                                   }),
                             moved("transposed", "transposed",
                                   [](int x, int y) {
                                       return std::pair{y, x};
                                   }),
                             turned()};
    list.push_back({"one_pixel_right", shifted(right, 1, 0), right, false, "shifted", {}, {}});
    list.push_back({"one_pixel_up", shifted(right, 0, -1), right, false, "shifted", {}, {}});
    list.push_back({"one_pixel_diagonally", shifted(right, 1, 1), right, false, "shifted", {}, {}});
    list.push_back({"two_pixels_left", shifted(right, -2, 0), right, false, "shifted", {}, {}});
    list.push_back({"half_a_pixel", picture_of_sphere({.offset_x = 0.5f}), right, false, {}, {}, {}});
    list.push_back({"zoomed_3_percent", picture_of_sphere({.zoom = 1.03f}), right, false, {}, {}, {}});
    list.push_back({"blurred", blurred(right), right, false, {}, {}, {}});
    list.push_back({"moved_object", picture_of_sphere({.sphere_x = -0.2f}), right, false, {}, {}, {}});
    list.push_back({"object_missing", picture_of_sphere({.has_sphere = false}), right, false, {}, {}, {}});
    return list;
}

} // namespace sr::testing
