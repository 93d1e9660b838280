#include "golden/density.hpp"

#include <algorithm>

namespace sr::golden {

double densest_window(const Pair& pair, const std::vector<bool>& fails) {
    const auto width = static_cast<std::size_t>(pair.reference.width);
    const auto height = static_cast<std::size_t>(pair.reference.height);
    const std::size_t stride = width + 1;
    std::vector<int> sums(stride * (height + 1), 0); // of all failing pixels above and to the left
    for (std::size_t k = 0; k < fails.size(); ++k)
        if (fails[k]) sums[(pair.compared[k] / width + 1) * stride + pair.compared[k] % width + 1] = 1;
    for (std::size_t y = 1; y <= height; ++y)
        for (std::size_t x = 1; x <= width; ++x)
            sums[y * stride + x] +=
                sums[(y - 1) * stride + x] + sums[y * stride + x - 1] - sums[(y - 1) * stride + x - 1];

    const std::size_t w = std::min<std::size_t>(density_window, width);
    const std::size_t h = std::min<std::size_t>(density_window, height);
    int most = 0;
    for (std::size_t y = h; y <= height; ++y)
        for (std::size_t x = w; x <= width; ++x)
            most = std::max(most, sums[y * stride + x] - sums[(y - h) * stride + x] - sums[y * stride + x - w]
                                      + sums[(y - h) * stride + x - w]);
    return static_cast<double>(most) / static_cast<double>(w * h);
}

} // namespace sr::golden
