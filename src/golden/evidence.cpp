#include "golden/evidence.hpp"

#include "golden/screen.hpp"

#include <fmt/format.h>

namespace sr::golden {
namespace {

constexpr std::size_t most_pixels = 1 << 16;
constexpr std::size_t fewest_failing = 32; // fewer fit too many mistakes
constexpr double nearly_all = 0.9;         // of the compared pixels: then the whole image says more

/// Evenly chosen, at most `most_pixels` of them.
std::vector<std::size_t> sampled(const std::vector<std::size_t>& pixels) {
    if (pixels.size() <= most_pixels) return pixels;
    std::vector<std::size_t> sample;
    for (std::size_t k = 0; k < most_pixels; ++k) sample.push_back(pixels[k * pixels.size() / most_pixels]);
    return sample;
}

std::vector<float> as_light(const image::Image& image, std::size_t colors, Encoding encoding) {
    std::vector<float> light;
    const auto channels = static_cast<std::size_t>(image.channels);
    for (std::size_t i = 0; i < image.pixels.size(); i += channels)
        for (std::size_t c = 0; c < colors; ++c) {
            const float value = image.pixels[i + c];
            light.push_back(encoding == Encoding::display_referred ? srgb_decoded(value) : value);
        }
    return light;
}

/// Whether the reference varies by half over these pixels: else any factor fits any change.
bool vary(const Evidence& evidence, const std::vector<std::size_t>& pixels) {
    std::vector<float> values;
    for (const std::size_t i : pixels)
        for (std::size_t c = 0; c < evidence.colors; ++c) values.push_back(evidence.r(i, c));
    std::ranges::sort(values);
    const float low = values[values.size() / 10], high = values[values.size() - 1 - values.size() / 10];
    return high > 1.5f * std::max(low, evidence.floor);
}

std::string place_of(const std::vector<std::size_t>& pixels, std::size_t width, std::size_t compared) {
    std::size_t left = width, right = 0;
    for (const std::size_t i : pixels) {
        left = std::min(left, i % width);
        right = std::max(right, i % width);
    }
    return fmt::format("in {:.2g} % of the pixels (columns {} to {}, rows {} to {})",
                       100.0 * static_cast<double>(pixels.size()) / static_cast<double>(compared), left,
                       right, pixels.front() / width, pixels.back() / width);
}

std::vector<std::size_t> significant(const Pair& pair, const PixelValues& z) {
    std::vector<std::size_t> pixels;
    for (std::size_t k = 0; k < z.size(); ++k)
        if (z[k] > 4.0f) pixels.push_back(pair.compared[k]);
    return pixels;
}

} // namespace

Evidence whole_evidence(const Pair& pair, Encoding encoding, const PixelValues* z) {
    Evidence evidence;
    evidence.width = pair.reference.width;
    evidence.height = pair.reference.height;
    evidence.colors = static_cast<std::size_t>(pair.colors);
    evidence.test = as_light(pair.test, evidence.colors, encoding);
    evidence.reference = as_light(pair.reference, evidence.colors, encoding);
    for (const Pixel pixel : pair.pixels) evidence.known.push_back(pixel == Pixel::compared);
    evidence.fitted = sampled(pair.compared);
    evidence.pixels = sampled(z ? significant(pair, *z) : pair.compared);
    evidence.floor = static_cast<float>(relative_floor(pair));
    if (encoding == Encoding::display_referred) {
        evidence.most = 1.0f;
        evidence.floor =
            std::max(evidence.floor, srgb_decoded(4.0f / 255.0f)); // 8-bit codes are coarse below
    }
    evidence.where = "everywhere";
    return evidence;
}

std::optional<Evidence> failing_evidence(const Evidence& whole, const Pair& pair, const image::Image& error) {
    std::vector<std::size_t> failing;
    for (const std::size_t i : pair.compared)
        if (error.pixels[i] > 1.0f) failing.push_back(i);
    if (failing.size() < fewest_failing) return std::nullopt;
    if (static_cast<double>(failing.size()) > nearly_all * static_cast<double>(pair.compared.size()))
        return std::nullopt;
    if (!vary(whole, failing)) return std::nullopt;
    Evidence evidence = whole;
    evidence.is_whole = false;
    evidence.where = place_of(failing, static_cast<std::size_t>(whole.width), pair.compared.size());
    evidence.pixels = evidence.fitted = sampled(failing);
    return evidence;
}

float median(std::vector<float> values) {
    if (values.empty()) return 0.0f;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

} // namespace sr::golden
