#include "golden/flip_color.hpp"

#include "core/math.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sr::golden {
namespace {

// Linear Rec. 709 to CIE XYZ under D65 (IEC 61966-2-1, in more digits); GLM's matrices are columns.
const mat3 xyz_from_rgb(vec3(0.4123908f, 0.2126390f, 0.0193308f), vec3(0.3575843f, 0.7151687f, 0.1191948f),
                        vec3(0.1804808f, 0.0721923f, 0.9505322f));
const mat3 rgb_from_xyz = glm::inverse(xyz_from_rgb);
const vec3 white = xyz_from_rgb * vec3(1.0f);

vec3 ycxcz(vec3 rgb) {
    const vec3 xyz = xyz_from_rgb * rgb / white;
    return {116.0f * xyz.y - 16.0f, 500.0f * (xyz.x - xyz.y), 200.0f * (xyz.y - xyz.z)};
}

vec3 rgb_from_ycxcz(vec3 ycc) {
    const float y = (ycc.x + 16.0f) / 116.0f;
    return rgb_from_xyz * (vec3(y + ycc.y / 500.0f, y, y - ycc.z / 200.0f) * white);
}

/// CIE 1976 L*a*b*, its chroma scaled by lightness (Hunt): what a person calls colourful in the dark is less.
vec3 hunt_lab(vec3 rgb) {
    const auto f = [](float t) {
        constexpr float delta = 6.0f / 29.0f;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
    };
    const vec3 xyz = xyz_from_rgb * rgb / white;
    const float fx = f(xyz.x), fy = f(xyz.y), fz = f(xyz.z);
    const float lightness = 116.0f * fy - 16.0f;
    return {lightness, 0.01f * lightness * 500.0f * (fx - fy), 0.01f * lightness * 200.0f * (fy - fz)};
}

/// Abasi et al. 2020: city block in lightness, Euclid in chroma.
float hyab(vec3 a, vec3 b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// A contrast sensitivity function in space: a sum of two Gaussians of distance in degrees (Andersson 2020,
/// Table 1).
struct Sensitivity {
    double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> sensitivities{Sensitivity{1.0, 0.0047, 0.0, 1e-5},   // achromatic
                                                   Sensitivity{1.0, 0.0053, 0.0, 1e-5},   // red-green
                                                   Sensitivity{34.1, 0.04, 13.5, 0.025}}; // blue-yellow
constexpr double widest = 0.04;

int sensitivity_radius(float pixels_per_degree) {
    return static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * std::numbers::pi * std::numbers::pi))
                                      * static_cast<double>(pixels_per_degree)));
}

Kernel gaussian(double b, int radius, float pixels_per_degree) {
    return sampled_kernel(radius, [&](double pixels) {
        const double degrees = pixels / static_cast<double>(pixels_per_degree);
        return std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / b);
    });
}

double sum(const Kernel& kernel) {
    double total = 0.0;
    for (const float value : kernel) total += static_cast<double>(value);
    return total;
}

/// The plane as the eye resolves it. The kernel, of unit sum, is separable term by term.
Plane filtered(const Plane& plane, const Sensitivity& s, float pixels_per_degree) {
    const int radius = sensitivity_radius(pixels_per_degree);
    const Kernel first = gaussian(s.b1, radius, pixels_per_degree);
    const double weight1 = s.a1 * std::sqrt(std::numbers::pi / s.b1), sum1 = sum(first);
    const Kernel second = gaussian(s.b2, radius, pixels_per_degree);
    const double weight2 = s.a2 * std::sqrt(std::numbers::pi / s.b2), sum2 = sum(second);
    const double total = weight1 * sum1 * sum1 + weight2 * sum2 * sum2;
    Plane result = convolved(plane, first, first);
    for (float& value : result.values) value *= static_cast<float>(weight1 / total);
    if (weight2 == 0.0) return result;
    const Plane wide = convolved(plane, second, second);
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] += static_cast<float>(weight2 / total) * wide.values[i];
    return result;
}

/// Filtered YCxCz as Hunt-adjusted L*a*b*, pixel by pixel.
std::vector<vec3> perceived(const Planes& image, float pixels_per_degree) {
    Planes planes;
    for (std::size_t c = 0; c < 3; ++c) planes[c] = filtered(image[c], sensitivities[c], pixels_per_degree);
    std::vector<vec3> lab;
    for (std::size_t i = 0; i < planes[0].values.size(); ++i) {
        const vec3 ycc(planes[0].values[i], planes[1].values[i], planes[2].values[i]);
        lab.push_back(hunt_lab(glm::clamp(rgb_from_ycxcz(ycc), vec3(0.0f), vec3(1.0f))));
    }
    return lab;
}

constexpr float color_exponent = 0.7f; // q_c
constexpr float knee = 0.4f;           // p_c: this share of the largest difference
constexpr float knee_value = 0.95f;    // p_t: takes this share of the range (Andersson 2020, section 4.1.3)

float redistributed(float difference, float largest) {
    const float power = std::pow(difference, color_exponent), bend = knee * largest;
    if (power < bend) return knee_value / bend * power;
    return knee_value + (power - bend) / (largest - bend) * (1.0f - knee_value);
}

} // namespace

Planes ycxcz(const Planes& rgb) {
    Planes result = rgb;
    for (std::size_t i = 0; i < rgb[0].values.size(); ++i) {
        const vec3 ycc = ycxcz(vec3(rgb[0].values[i], rgb[1].values[i], rgb[2].values[i]));
        for (int c = 0; c < 3; ++c) result[static_cast<std::size_t>(c)].values[i] = ycc[c];
    }
    return result;
}

Plane color_difference(const Planes& test, const Planes& reference, float pixels_per_degree) {
    const float largest =
        std::pow(hyab(hunt_lab(vec3(0.0f, 1.0f, 0.0f)), hunt_lab(vec3(0.0f, 0.0f, 1.0f))), color_exponent);
    const auto a = perceived(test, pixels_per_degree), b = perceived(reference, pixels_per_degree);
    Plane result(test[0].width, test[0].height);
    for (std::size_t i = 0; i < a.size(); ++i) result.values[i] = redistributed(hyab(a[i], b[i]), largest);
    return result;
}

} // namespace sr::golden
