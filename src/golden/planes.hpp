#pragma once
// Single channels and their convolution: what FLIP and SSIM are made of.
#include <functional>
#include <span>
#include <vector>

namespace sr::golden {

/// One channel, rows from top to bottom.
struct Plane {
    int width = 0;
    int height = 0;
    std::vector<float> values;

    Plane() = default;
    Plane(int plane_width, int plane_height)
        : width(plane_width),
          height(plane_height),
          values(static_cast<std::size_t>(plane_width) * static_cast<std::size_t>(plane_height)) {}
};

/// A kernel of 2 radius + 1 values.
using Kernel = std::vector<float>;

/// Values of `f` at -radius … radius.
Kernel sampled_kernel(int radius, const std::function<double(double)>& f);

/// `horizontal` along the rows, then `vertical` along the columns. The border's pixels continue outside.
Plane convolved(const Plane& plane, const Kernel& horizontal, const Kernel& vertical);

} // namespace sr::golden
