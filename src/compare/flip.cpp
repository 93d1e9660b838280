#include "compare/flip.hpp"

#include "core/math.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sr::compare {
namespace {

using image::Image;

/// Three channels of one image: linear RGB, or YCxCz.
using Planes = std::array<Plane, 3>;

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

/// CIE 1976 L*a*b* with chroma scaled by lightness: colourfulness decreases in the dark (Hunt effect).
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
constexpr double max_width = 0.04;

int sensitivity_radius(float pixels_per_degree) {
    return static_cast<int>(std::ceil(3.0 * std::sqrt(max_width / (2.0 * std::numbers::pi * std::numbers::pi))
                                      * static_cast<double>(pixels_per_degree)));
}

Kernel gaussian(double b, int radius, float pixels_per_degree) {
    return sample_kernel(radius, [&](double pixels) {
        const double degrees = pixels / static_cast<double>(pixels_per_degree);
        return std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / b);
    });
}

double sum(const Kernel& kernel) {
    double total = 0.0;
    for (const float value : kernel) total += static_cast<double>(value);
    return total;
}

/// The plane as the eye resolves it. Each term of the kernel is separable; the kernel's sum is 1.
Plane filtered(const Plane& plane, const Sensitivity& s, float pixels_per_degree) {
    const int radius = sensitivity_radius(pixels_per_degree);
    const Kernel first = gaussian(s.b1, radius, pixels_per_degree);
    const double weight1 = s.a1 * std::sqrt(std::numbers::pi / s.b1), sum1 = sum(first);
    const Kernel second = gaussian(s.b2, radius, pixels_per_degree);
    const double weight2 = s.a2 * std::sqrt(std::numbers::pi / s.b2), sum2 = sum(second);
    const double total = weight1 * sum1 * sum1 + weight2 * sum2 * sum2;
    Plane result = convolve(plane, first, first);
    for (float& value : result.values) value *= static_cast<float>(weight1 / total);
    if (weight2 == 0.0) return result;
    const Plane wide = convolve(plane, second, second);
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

/// Converts linear RGB in 0..1 to YCxCz (Andersson 2020, section 4.1.1).
Planes ycxcz(const Planes& rgb) {
    Planes result = rgb;
    for (std::size_t i = 0; i < rgb[0].values.size(); ++i) {
        const vec3 ycc = ycxcz(vec3(rgb[0].values[i], rgb[1].values[i], rgb[2].values[i]));
        for (int c = 0; c < 3; ++c) result[static_cast<std::size_t>(c)].values[i] = ycc[c];
    }
    return result;
}

/// The colour half: filtered by the contrast sensitivity of the eye and compared in a uniform space.
/// @return the difference of two YCxCz images at each pixel, 0..1 (Andersson 2020, section 4.1)
Plane color_difference(const Planes& test, const Planes& reference, float pixels_per_degree) {
    const float largest =
        std::pow(hyab(hunt_lab(vec3(0.0f, 1.0f, 0.0f)), hunt_lab(vec3(0.0f, 0.0f, 1.0f))), color_exponent);
    const auto a = perceived(test, pixels_per_degree), b = perceived(reference, pixels_per_degree);
    Plane result(test[0].width, test[0].height);
    for (std::size_t i = 0; i < a.size(); ++i) result.values[i] = redistributed(hyab(a[i], b[i]), largest);
    return result;
}

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
    Kernel blur = sample_kernel(radius, gauss);
    float sum = 0.0f;
    for (const float value : blur) sum += value;
    for (float& value : blur) value /= sum;
    return {blur, balanced(sample_kernel(radius, [&](double x) { return -x * gauss(x); })),
            balanced(
                sample_kernel(radius, [&](double x) { return (x * x / (sigma * sigma) - 1.0) * gauss(x); }))};
}

/// Length of the response along both axes.
Plane magnitude(const Plane& plane, const Kernel& detector, const Kernel& blur) {
    Plane along_x = convolve(plane, detector, blur);
    const Plane along_y = convolve(plane, blur, detector);
    for (std::size_t i = 0; i < along_x.values.size(); ++i)
        along_x.values[i] = std::hypot(along_x.values[i], along_y.values[i]);
    return along_x;
}

/// Y of YCxCz, scaled to 0..1.
Plane normalised(Plane achromatic) {
    for (float& value : achromatic.values) value = (value + 16.0f) / 116.0f;
    return achromatic;
}

/// The feature half: edges and points that only one image has.
/// @return the difference of two planes Y of YCxCz at each pixel, 0..1 (Andersson 2020, section 4.2)
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

vec3 color_at(const Image& image, std::size_t pixel) {
    const float* values = image.pixels.data() + pixel * static_cast<std::size_t>(image.channels);
    return image.channels < 3 ? vec3(values[0]) : vec3(values[0], values[1], values[2]);
}

/// Each colour through `f`, clamped to what a screen shows.
template<typename Function>
Planes shown(const Image& image, Function&& f) {
    Planes planes;
    planes.fill(Plane(image.width, image.height));
    for (std::size_t i = 0; i < planes[0].values.size(); ++i) {
        const vec3 rgb = glm::clamp(f(color_at(image, i)), vec3(0.0f), vec3(1.0f));
        for (int c = 0; c < 3; ++c) planes[static_cast<std::size_t>(c)].values[i] = rgb[c];
    }
    return planes;
}

Plane flip_of_planes(const Planes& test_rgb, const Planes& reference_rgb, float pixels_per_degree) {
    const Planes test = ycxcz(test_rgb), reference = ycxcz(reference_rgb);
    Plane result = color_difference(test, reference, pixels_per_degree);
    const Plane features = feature_difference(test[0], reference[0], pixels_per_degree);
    for (std::size_t i = 0; i < result.values.size(); ++i)
        result.values[i] =
            std::pow(result.values[i], 1.0f - features.values[i]); // Andersson 2020, section 4.3
    return result;
}

/// Narkowicz' curve with the factor 0.6 that its author suggests, as Andersson 2021 uses it.
vec3 tone_mapped(vec3 light) { return image::aces(0.6f * light); }

/// The light that `tone_mapped` turns into 0.85: x in (a x² + b x) / (c x² + d x + e) = 0.85.
double light_near_white() {
    constexpr double t = 0.85, a = 2.51, b = 0.03, c = 2.43, d = 0.59, e = 0.14;
    constexpr double A = a - t * c, B = b - t * d, C = -t * e;
    return (-B + std::sqrt(B * B - 4.0 * A * C)) / (2.0 * A) / 0.6;
}

} // namespace

Plane flip(const Image& test, const Image& reference, float pixels_per_degree) {
    const auto as_is = [](vec3 rgb) { return rgb; };
    return flip_of_planes(shown(test, as_is), shown(reference, as_is), pixels_per_degree);
}

Plane hdr_flip(const Image& test, const Image& reference, const Exposures& exposures,
               float pixels_per_degree) {
    Plane worst(reference.width, reference.height);
    for (int i = 0; i < exposures.count; ++i) {
        const double step =
            exposures.count > 1 ? (exposures.stop - exposures.start) / (exposures.count - 1) : 0.0;
        const float factor = static_cast<float>(std::exp2(exposures.start + i * step));
        const auto at_exposure = [factor](vec3 light) { return tone_mapped(factor * light); };
        const Plane plane =
            flip_of_planes(shown(test, at_exposure), shown(reference, at_exposure), pixels_per_degree);
        for (std::size_t p = 0; p < plane.values.size(); ++p)
            worst.values[p] = std::max(worst.values[p], plane.values[p]);
    }
    return worst;
}

Exposures exposures_for(const Image& reference) {
    std::vector<float> lit;
    for (std::size_t i = 0; i < reference.pixels.size() / static_cast<std::size_t>(reference.channels); ++i) {
        const float Y = luminance(color_at(reference, i));
        if (Y > 0.0f && std::isfinite(Y)) lit.push_back(Y);
    }
    if (lit.empty()) return {0.0, 0.0, 1};
    const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
    std::ranges::nth_element(lit, middle);
    const double median = static_cast<double>(*middle), largest = static_cast<double>(std::ranges::max(lit));
    constexpr double max_stops = 16.0;
    const double stop = std::log2(light_near_white() / median);
    const double start = std::max(std::log2(light_near_white() / largest), stop - max_stops);
    return {start, stop, std::max(2, static_cast<int>(std::ceil(stop - start)))};
}

} // namespace sr::compare
