#include "golden/known_pixels.hpp"

#include "compare/align.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sr::golden {

std::string wrong_known_pixels(const image::Image& image, std::span<const KnownPixel> pixels) {
    const auto channels = compare::color_channels(image);
    for (const KnownPixel& pixel : pixels) {
        if (pixel.x >= image.width || pixel.y >= image.height)
            return fmt::format("the known pixel ({}, {}) lies outside the image", pixel.x, pixel.y);
        std::array<double, 3> found{};
        bool is_right = true;
        for (std::size_t c = 0; c < 3; ++c) {
            found[c] = image.at(pixel.x, pixel.y)[channels[c]];
            is_right =
                is_right
                && std::abs(found[c] - pixel.radiance[c]) <= pixel.relative * std::abs(pixel.radiance[c]);
        }
        if (!is_right)
            return fmt::format("pixel ({}, {}) is {:.6g} {:.6g} {:.6g}, in closed form it is {:.6g} {:.6g} "
                               "{:.6g} (± {:g} %)",
                               pixel.x, pixel.y, found[0], found[1], found[2], pixel.radiance[0],
                               pixel.radiance[1], pixel.radiance[2], 100.0 * pixel.relative);
    }
    return {};
}

} // namespace sr::golden
