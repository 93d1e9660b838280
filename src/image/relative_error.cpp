#include "image/relative_error.hpp"

#include <algorithm>
#include <cmath>

namespace sr::image {

double relative_floor(std::vector<float> colors) {
    std::erase(colors, 0.0f);
    if (colors.empty()) return 0.0;
    for (float& color : colors) color = std::abs(color);
    const auto middle = colors.begin() + static_cast<std::ptrdiff_t>(colors.size() / 2);
    std::ranges::nth_element(colors, middle);
    return 0.01 * static_cast<double>(*middle);
}

double relative_square(double difference, double reference, double floor) {
    if (difference == 0.0) return 0.0;
    return difference * difference / (reference * reference + floor * floor);
}

} // namespace sr::image
