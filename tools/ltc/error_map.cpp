#include "error_map.hpp"

#include "core/math.hpp"
#include "image/file.hpp"
#include "ltc/trial.hpp"

#include <algorithm>
#include <array>

namespace sr::ltc {
namespace {

constexpr int side = 20;      // cells a side
constexpr int cell_pixels = 12;
constexpr int each = 25;      // emitters a cell
constexpr std::array points{0, 16};

/// Up to which median error, and its colour (sRGB); the last is for all above.
struct Step {
    double error;
    vec3 color;
};
constexpr std::array steps{Step{0.002, {0.10f, 0.20f, 0.42f}}, Step{0.005, {0.20f, 0.44f, 0.62f}},
                           Step{0.01, {0.45f, 0.68f, 0.72f}},  Step{0.02, {0.80f, 0.88f, 0.78f}},
                           Step{0.05, {0.98f, 0.84f, 0.45f}},  Step{0.1, {0.93f, 0.55f, 0.25f}},
                           Step{1e9, {0.70f, 0.15f, 0.15f}}};

vec3 color_of(double error) {
    return std::find_if(steps.begin(), steps.end() - 1, [&](const Step& s) { return error <= s.error; })->color;
}

void fill(image::Image& picture, int x, int y, int width, int height, vec3 color) {
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column) {
            const auto pixel = picture.at(column, row);
            for (int c = 0; c < 3; ++c) pixel[c] = color[c];
        }
}

std::vector<Trial> all_trials() {
    std::vector<Trial> all;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            constexpr double degree = 3.14159265358979 / 180.0;
            const double angle = 88.0 * degree * column / (side - 1);
            const Cell cell{0.05 * (row + 1), angle, angle};
            const auto found =
                trials(Shape::polygon, Material::metal, cell, each, static_cast<std::uint64_t>(row * side + column), 1 << 13);
            all.insert(all.end(), found.begin(), found.end());
        }
    return all;
}

} // namespace

void write_error_map(const std::filesystem::path& file) {
    constexpr int panel = side * cell_pixels;
    image::Image picture(2 * panel + cell_pixels, panel + 2 * cell_pixels, 3);
    std::fill(picture.pixels.begin(), picture.pixels.end(), 1.0f);
    const std::vector<Trial> all = all_trials();
    for (std::size_t p = 0; p < points.size(); ++p) {
        const std::vector<double> reflected = evaluated(all, Material::metal, points[p]);
        for (int i = 0; i < side * side; ++i) {
            const auto first = static_cast<std::size_t>(i * each);
            const auto cell = errors(std::span(all).subspan(first, each), std::span(reflected).subspan(first, each));
            fill(picture, static_cast<int>(p) * (panel + cell_pixels) + i % side * cell_pixels, i / side * cell_pixels,
                 cell_pixels, cell_pixels, color_of(cell[each / 2]));
        }
    }
    for (std::size_t s = 0; s < steps.size(); ++s)
        fill(picture, static_cast<int>(s) * 3 * cell_pixels, panel + cell_pixels, 3 * cell_pixels, cell_pixels, steps[s].color);
    image::write(picture, file, image::SampleType::integer8);
}

} // namespace sr::ltc
