#include "golden/noise.hpp"

#include "core/error.hpp"
#include "golden/layer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::golden {
namespace {

using image::Image;

constexpr double false_alarms = 1e-3; // of all comparisons of equal images
constexpr double rounding = 1e-6;     // relative; eight units in the last place of a float

/// A noise image's colours: as many as the pair's, or one for all of them.
Image checked(const Image& noise, const Pair& pair) {
    const bool is_one_value = noise.width == 1 && noise.height == 1;
    if (!is_one_value && (noise.width != pair.reference.width || noise.height != pair.reference.height))
        throw Error(fmt::format("the noise is {}x{}, the reference {}x{}", noise.width, noise.height,
                                pair.reference.width, pair.reference.height),
                    "give a number, or an image of the reference's size");
    const auto layer = layer_of(noise, "");
    if (!layer || (layer->colors.size() != 1 && static_cast<int>(layer->colors.size()) != pair.colors))
        throw Error("the noise has other channels than the images",
                    "give it the channels R, G and B, or only one");
    Image colors = extracted(noise, layer->colors);
    if (!std::ranges::all_of(colors.pixels, [](float s) { return std::isfinite(s) && s >= 0.0f; }))
        throw Error("the noise has values that are negative or not finite",
                    "give standard errors, from 0 up");
    return colors;
}

/// Variances of t - r, laid out as the pair's colours.
std::vector<double> variances(const Pair& pair, const std::vector<Image>& noise) {
    const auto colors = static_cast<std::size_t>(pair.colors);
    std::vector<double> sums(pair.pixels.size() * colors, 0.0);
    for (const Image& given : noise) {
        const Image errors = checked(given, pair);
        const bool is_one_value = errors.width == 1 && errors.height == 1;
        const auto channels = static_cast<std::size_t>(errors.channels);
        for (std::size_t i = 0; i < pair.pixels.size(); ++i)
            for (std::size_t c = 0; c < colors; ++c) {
                const double s = errors.pixels[(is_one_value ? 0 : i * channels) + std::min(c, channels - 1)];
                sums[i * colors + c] += s * s;
            }
    }
    for (std::size_t i = 0; i < pair.pixels.size(); ++i)
        for (std::size_t c = 0; c < colors; ++c) {
            const double error = rounding * static_cast<double>(pair.reference_at(i)[c]);
            sums[i * colors + c] += error * error;
        }
    return sums;
}

/// A difference whose variance is known, or a sum of such.
struct Deviation {
    double difference = 0.0;
    double variance = 0.0;

    double z() const {
        if (difference == 0.0) return 0.0;
        return std::abs(difference) / std::sqrt(variance); // infinite where no noise is expected
    }
    Deviation& operator+=(const Deviation& other) {
        difference += other.difference;
        variance += other.variance;
        return *this;
    }
};

} // namespace

double two_sided_z(double chance) {
    double low = 0.0, high = 40.0; // erfc(40 / sqrt 2) is 0 in double
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (low + high);
        (std::erfc(middle / std::sqrt(2.0)) > chance ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

NoiseScores scored(const Pair& pair, const std::vector<Image>& noise) {
    const auto colors = static_cast<std::size_t>(pair.colors);
    const auto width = static_cast<std::size_t>(pair.reference.width);
    const std::size_t columns = (width + noise_block - 1) / noise_block;
    const std::size_t rows =
        (static_cast<std::size_t>(pair.reference.height) + noise_block - 1) / noise_block;
    const std::vector<double> variance = variances(pair, noise);
    std::vector<Deviation> blocks(columns * rows * colors), totals(colors);

    NoiseScores scores;
    scores.pixels.reserve(pair.compared.size());
    for (const std::size_t i : pair.compared) {
        double largest = 0.0;
        const std::size_t block = i / width / noise_block * columns + i % width / noise_block;
        for (std::size_t c = 0; c < colors; ++c) {
            const double difference =
                static_cast<double>(pair.test_at(i)[c]) - static_cast<double>(pair.reference_at(i)[c]);
            const Deviation deviation{difference, variance[i * colors + c]};
            largest = std::max(largest, deviation.z());
            blocks[block * colors + c] += deviation;
            totals[c] += deviation;
        }
        scores.pixels.push_back(static_cast<float>(largest));
    }
    for (const Deviation& block : blocks) scores.max_block = std::max(scores.max_block, block.z());
    for (const Deviation& total : totals) scores.total = std::max(scores.total, total.z());
    const double chance = false_alarms / 3.0 / static_cast<double>(colors);
    scores.limits = {
        two_sided_z(chance / static_cast<double>(std::max<std::size_t>(pair.compared.size(), 1))),
        two_sided_z(chance / static_cast<double>(columns * rows)), two_sided_z(chance)};
    return scores;
}

} // namespace sr::golden
