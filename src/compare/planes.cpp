#include "compare/planes.hpp"

#include "core/math.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <cmath>

namespace sr::compare {
namespace {

int radius_of(const Kernel& kernel) { return static_cast<int>(kernel.size() / 2); }

Plane convolve_rows(const Plane& plane, const Kernel& kernel) {
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

Plane convolve_columns(const Plane& plane, const Kernel& kernel) {
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

double mean(const Plane& plane) {
    double sum = 0.0;
    for (const float value : plane.values) sum += static_cast<double>(value);
    return sum / static_cast<double>(plane.values.size());
}

Kernel sample_kernel(int radius, const std::function<double(double)>& f) {
    Kernel kernel;
    for (int i = -radius; i <= radius; ++i) kernel.push_back(static_cast<float>(f(i)));
    return kernel;
}

Plane convolve(const Plane& plane, const Kernel& horizontal, const Kernel& vertical) {
    return convolve_columns(convolve_rows(plane, horizontal), vertical);
}

namespace {

using image::Image;

/// The first three channels, or grey three times, clamped to what a code can be.
Image codes_of(const Image& image) {
    Image codes(image.width, image.height, 3);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                codes.at(x, y)[c] = std::clamp(image.at(x, y)[image.channels < 3 ? 0 : c], 0.0f, 1.0f);
    return codes;
}

} // namespace

DisplayedImages display(const Image& test, const Image& reference, bool is_light) {
    if (!is_light) return {codes_of(test), codes_of(reference)};
    const float ev100 = image::auto_ev100(reference);
    return {image::displayed(test, ev100), image::displayed(reference, ev100)};
}

Image screen_light(const Image& codes) {
    Image light = codes;
    for (float& value : light.pixels) value = srgb_decoded(value);
    return light;
}

Plane luma(const Image& codes) {
    Plane plane(codes.width, codes.height);
    for (std::size_t i = 0; i < plane.values.size(); ++i)
        plane.values[i] = luminance(codes.pixels[3 * i], codes.pixels[3 * i + 1], codes.pixels[3 * i + 2]);
    return plane;
}

float srgb_decoded(float code) { return std::copysign(image::linear_of_srgb(std::abs(code)), code); }

float srgb_encoded_unclamped(float linear) {
    return std::copysign(image::srgb_of_linear(std::abs(linear)), linear);
}

} // namespace sr::compare
