#include "golden/flip.hpp"

#include "core/math.hpp"
#include "golden/flip_color.hpp"
#include "golden/flip_feature.hpp"
#include "core/luminance.hpp"
#include "image/tone_curve.hpp"

#include <algorithm>
#include <cmath>

namespace sr::golden {
namespace {

using image::Image;

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
    constexpr double most_stops = 16.0;
    const double stop = std::log2(light_near_white() / median);
    const double start = std::max(std::log2(light_near_white() / largest), stop - most_stops);
    return {start, stop, std::max(2, static_cast<int>(std::ceil(stop - start)))};
}

double mean(const Plane& plane) {
    double sum = 0.0;
    for (const float value : plane.values) sum += static_cast<double>(value);
    return sum / static_cast<double>(plane.values.size());
}

} // namespace sr::golden
