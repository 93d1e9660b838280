#include "golden/planes.hpp"

#include <algorithm>

namespace sr::golden {
namespace {

int radius_of(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

Plane convolved_rows(const Plane& plane, const Kernel& kernel) {
    const int radius = radius_of(kernel);
    const auto width = static_cast<std::size_t>(plane.width);
    Plane result(plane.width, plane.height);
    std::vector<float> padded(width + 2 * static_cast<std::size_t>(radius));
    for (int y = 0; y < plane.height; ++y) {
        const float* row = plane.values.data() + static_cast<std::size_t>(y) * width;
        std::fill_n(padded.begin(), radius, row[0]);
        std::copy_n(row, width, padded.begin() + radius);
        std::fill_n(padded.begin() + radius + plane.width, radius, row[width - 1]);
        float* out = result.values.data() + static_cast<std::size_t>(y) * width;
        for (std::size_t k = 0; k < kernel.size(); ++k)
            for (std::size_t x = 0; x < width; ++x) out[x] += kernel[k] * padded[x + k];
    }
    return result;
}

Plane convolved_columns(const Plane& plane, const Kernel& kernel) {
    const int radius = radius_of(kernel);
    const auto width = static_cast<std::size_t>(plane.width);
    Plane result(plane.width, plane.height);
    for (int y = 0; y < plane.height; ++y) {
        float* out = result.values.data() + static_cast<std::size_t>(y) * width;
        for (int k = -radius; k <= radius; ++k) {
            const int from = std::clamp(y + k, 0, plane.height - 1);
            const float* row = plane.values.data() + static_cast<std::size_t>(from) * width;
            const float weight = kernel[static_cast<std::size_t>(k + radius)];
            for (std::size_t x = 0; x < width; ++x) out[x] += weight * row[x];
        }
    }
    return result;
}

} // namespace

Kernel sampled_kernel(int radius, const std::function<double(double)>& f) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) kernel.push_back(static_cast<float>(f(i)));
    return kernel;
}

Plane convolved(const Plane& plane, const Kernel& horizontal, const Kernel& vertical) {
    return convolved_columns(convolved_rows(plane, horizontal), vertical);
}

} // namespace sr::golden
