#include "golden/ssim.hpp"

#include <cmath>

namespace sr::golden {
namespace {

constexpr int radius = 5;
constexpr double sigma = 1.5;
constexpr double c1 = 0.01 * 0.01; // (K1 L)² and (K2 L)² with L = 1 (Wang 2004, section III.B)
constexpr double c2 = 0.03 * 0.03;

Plane product(const Plane& a, const Plane& b) {
    Plane result = a;
    for (std::size_t i = 0; i < a.values.size(); ++i) result.values[i] *= b.values[i];
    return result;
}

Kernel window() {
    Kernel kernel = sampled_kernel(radius, [](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); });
    float sum = 0.0f;
    for (const float value : kernel) sum += value;
    for (float& value : kernel) value /= sum;
    return kernel;
}

} // namespace

double ssim(const Plane& test, const Plane& reference) {
    const Kernel kernel = window();
    const auto averaged = [&kernel](const Plane& plane) { return convolved(plane, kernel, kernel); };
    const Plane mean_t = averaged(test), mean_r = averaged(reference);
    const Plane tt = averaged(product(test, test)), rr = averaged(product(reference, reference));
    const Plane tr = averaged(product(test, reference));

    const bool has_inside = test.width > 2 * radius && test.height > 2 * radius;
    const int border = has_inside ? radius : 0;
    double sum = 0.0;
    for (int y = border; y < test.height - border; ++y)
        for (int x = border; x < test.width - border; ++x) {
            const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(test.width)
                           + static_cast<std::size_t>(x);
            const double mt = mean_t.values[i], mr = mean_r.values[i];
            const double covariance = tr.values[i] - mt * mr;
            const double variances = tt.values[i] - mt * mt + rr.values[i] - mr * mr;
            sum += (2.0 * mt * mr + c1) * (2.0 * covariance + c2)
                   / ((mt * mt + mr * mr + c1) * (variances + c2)); // Eq. 13
        }
    return sum / (static_cast<double>(test.width - 2 * border) * (test.height - 2 * border));
}

} // namespace sr::golden
