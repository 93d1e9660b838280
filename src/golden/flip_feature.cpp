#include "golden/flip_feature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sr::golden {
namespace {

/// A kernel whose positive values sum to 1 and whose negative ones to -1.
Kernel balanced(Kernel kernel) {
    float positive = 0.0f, negative = 0.0f;
    for (const float value : kernel) (value > 0.0f ? positive : negative) += std::abs(value);
    for (float& value : kernel) value /= value > 0.0f ? positive : negative;
    return kernel;
}

struct Detectors {
    Kernel blur;
    Kernel edge;  // first derivative of the Gaussian
    Kernel point; // second derivative
};

Detectors detectors(float pixels_per_degree) {
    constexpr double width_degrees = 0.082; // w: an edge's width (Andersson 2020, section 4.2.1)
    const double sigma = 0.5 * width_degrees * static_cast<double>(pixels_per_degree);
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const auto gauss = [sigma](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); };
    Kernel blur = sampled_kernel(radius, gauss);
    float sum = 0.0f;
    for (const float value : blur) sum += value;
    for (float& value : blur) value /= sum;
    return {blur, balanced(sampled_kernel(radius, [&](double x) { return -x * gauss(x); })),
            balanced(sampled_kernel(radius,
                                    [&](double x) { return (x * x / (sigma * sigma) - 1.0) * gauss(x); }))};
}

/// Length of the response along both axes.
Plane magnitude(const Plane& plane, const Kernel& detector, const Kernel& blur) {
    Plane along_x = convolved(plane, detector, blur);
    const Plane along_y = convolved(plane, blur, detector);
    for (std::size_t i = 0; i < along_x.values.size(); ++i)
        along_x.values[i] = std::hypot(along_x.values[i], along_y.values[i]);
    return along_x;
}

/// Y of YCxCz, scaled to 0..1.
Plane normalised(Plane achromatic) {
    for (float& value : achromatic.values) value = (value + 16.0f) / 116.0f;
    return achromatic;
}

} // namespace

Plane feature_difference(const Plane& test, const Plane& reference, float pixels_per_degree) {
    const auto [blur, edge, point] = detectors(pixels_per_degree);
    const Plane t = normalised(test), r = normalised(reference);
    const Plane test_edges = magnitude(t, edge, blur), reference_edges = magnitude(r, edge, blur);
    const Plane test_points = magnitude(t, point, blur), reference_points = magnitude(r, point, blur);
    Plane result(test.width, test.height);
    for (std::size_t i = 0; i < result.values.size(); ++i) {
        const float larger = std::max(std::abs(test_edges.values[i] - reference_edges.values[i]),
                                      std::abs(test_points.values[i] - reference_points.values[i]));
        result.values[i] = std::sqrt(larger / std::numbers::sqrt2_v<float>); // q_f = 0.5
    }
    return result;
}

} // namespace sr::golden
