#include "compare/metrics.hpp"

#include "core/error.hpp"
#include "image/relative_error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::compare {
namespace {

using image::Image;

double relative(double difference, double scale) {
    if (difference == 0.0) return 0.0;
    return std::abs(difference) / scale; // infinite for a scale of 0
}

/// Sums of one channel.
struct Sums {
    double test = 0.0;
    double reference = 0.0;
    double abs = 0.0;
    double rel = 0.0;
    double square = 0.0;
    double relative_square = 0.0;
};

Sums summed(const AlignedImages& images, std::size_t channel, double floor) {
    const bool is_color = static_cast<int>(channel) < images.colors;
    Sums sums;
    for (const std::size_t i : images.compared) {
        const double t = images.test_at(i)[channel], r = images.reference_at(i)[channel], d = t - r;
        sums.test += t;
        sums.reference += r;
        sums.abs += std::abs(d);
        sums.square += d * d;
        sums.rel += relative(d, is_color ? std::max(std::abs(r), floor) : 1.0);
        sums.relative_square += is_color ? image::relative_square(d, r, floor) : d * d;
    }
    return sums;
}

double ratio(double test, double reference) {
    if (test == reference) return 1.0;
    return test / reference; // infinite where the reference is black
}

} // namespace

double relative_floor(const AlignedImages& images) {
    std::vector<float> colors;
    for (const std::size_t i : images.compared) {
        const auto r = images.reference_at(i).first(static_cast<std::size_t>(images.colors));
        colors.insert(colors.end(), r.begin(), r.end());
    }
    return image::relative_floor(std::move(colors));
}

PixelValues absolute_differences(const AlignedImages& images) {
    PixelValues values;
    values.reserve(images.compared.size());
    for (const std::size_t i : images.compared) {
        const auto t = images.test_at(i), r = images.reference_at(i);
        float largest = 0.0f;
        for (std::size_t c = 0; c < r.size(); ++c) largest = std::max(largest, std::abs(t[c] - r[c]));
        values.push_back(largest);
    }
    return values;
}

PixelValues relative_differences(const AlignedImages& images, double floor) {
    PixelValues values;
    values.reserve(images.compared.size());
    for (const std::size_t i : images.compared) {
        const auto t = images.test_at(i), r = images.reference_at(i);
        double largest = 0.0;
        for (std::size_t c = 0; c < r.size(); ++c) {
            const bool is_color = static_cast<int>(c) < images.colors;
            const double scale = is_color ? std::max(std::abs(static_cast<double>(r[c])), floor) : 1.0;
            largest =
                std::max(largest, relative(static_cast<double>(t[c]) - static_cast<double>(r[c]), scale));
        }
        values.push_back(static_cast<float>(largest));
    }
    return values;
}

void measure_differences(const AlignedImages& images, Metrics& metrics) {
    metrics.pixels = images.compared.size();
    metrics.nonfinite_test = images.nonfinite_test;
    metrics.nonfinite_reference = images.nonfinite_reference;
    if (images.compared.empty()) return;
    metrics.floor = relative_floor(images);
    metrics.max_abs = std::ranges::max(absolute_differences(images));
    metrics.max_rel = std::ranges::max(relative_differences(images, metrics.floor));
    Sums all;
    for (std::size_t c = 0; c < static_cast<std::size_t>(images.reference.channels); ++c) {
        const Sums sums = summed(images, c, metrics.floor);
        all.abs += sums.abs;
        all.rel += sums.rel;
        all.square += sums.square;
        all.relative_square += sums.relative_square;
        if (images.colors == 1 && c == 0) metrics.energy_ratio.fill(ratio(sums.test, sums.reference));
        if (images.colors == 3 && c < 3) metrics.energy_ratio[c] = ratio(sums.test, sums.reference);
    }
    const auto count = static_cast<double>(images.compared.size()) * images.reference.channels;
    metrics.mean_abs = all.abs / count;
    metrics.mean_rel = all.rel / count;
    metrics.rmse = std::sqrt(all.square / count);
    metrics.rel_mse = all.relative_square / count;
}

double densest_window(const AlignedImages& images, const std::vector<bool>& fails) {
    const auto width = static_cast<std::size_t>(images.reference.width);
    const auto height = static_cast<std::size_t>(images.reference.height);
    const std::size_t stride = width + 1;
    std::vector<int> sums(stride * (height + 1), 0); // of all failing pixels above and to the left
    for (std::size_t k = 0; k < fails.size(); ++k)
        if (fails[k]) sums[(images.compared[k] / width + 1) * stride + images.compared[k] % width + 1] = 1;
    for (std::size_t y = 1; y <= height; ++y)
        for (std::size_t x = 1; x <= width; ++x)
            sums[y * stride + x] +=
                sums[(y - 1) * stride + x] + sums[y * stride + x - 1] - sums[(y - 1) * stride + x - 1];

    const std::size_t w = std::min<std::size_t>(density_window, width);
    const std::size_t h = std::min<std::size_t>(density_window, height);
    int most = 0;
    for (std::size_t y = h; y <= height; ++y)
        for (std::size_t x = w; x <= width; ++x)
            most = std::max(most, sums[y * stride + x] - sums[(y - h) * stride + x] - sums[y * stride + x - w]
                                      + sums[(y - h) * stride + x - w]);
    return static_cast<double>(most) / static_cast<double>(w * h);
}

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
    Kernel kernel = sample_kernel(radius, [](double x) { return std::exp(-x * x / (2.0 * sigma * sigma)); });
    float sum = 0.0f;
    for (const float value : kernel) sum += value;
    for (float& value : kernel) value /= sum;
    return kernel;
}

} // namespace

double ssim(const Plane& test, const Plane& reference) {
    const Kernel kernel = window();
    const auto averaged = [&kernel](const Plane& plane) { return convolve(plane, kernel, kernel); };
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

namespace {

constexpr double false_alarms = 1e-3; // of all comparisons of equal images
constexpr double rounding = 1e-6;     // relative; eight units in the last place of a float

/// A noise image's colours: as many as the images's, or one for all of them.
Image checked(const Image& noise, const AlignedImages& images) {
    const bool is_one_value = noise.width == 1 && noise.height == 1;
    if (!is_one_value && (noise.width != images.reference.width || noise.height != images.reference.height))
        throw Error(fmt::format("the noise is {}x{}, the reference {}x{}", noise.width, noise.height,
                                images.reference.width, images.reference.height),
                    "give a number, or an image of the reference's size");
    const auto layer = layer_of(noise, "");
    if (!layer || (layer->colors.size() != 1 && static_cast<int>(layer->colors.size()) != images.colors))
        throw Error("the noise has other channels than the images",
                    "give it the channels R, G and B, or only one");
    Image colors = extract(noise, layer->colors);
    if (!std::ranges::all_of(colors.pixels, [](float s) { return std::isfinite(s) && s >= 0.0f; }))
        throw Error("the noise has values that are negative or not finite",
                    "give standard errors, from 0 up");
    return colors;
}

/// Variances of t - r, laid out as the images's colours.
std::vector<double> variances(const AlignedImages& images, const std::vector<Image>& noise) {
    const auto colors = static_cast<std::size_t>(images.colors);
    std::vector<double> sums(images.pixels.size() * colors, 0.0);
    for (const Image& given : noise) {
        const Image errors = checked(given, images);
        const bool is_one_value = errors.width == 1 && errors.height == 1;
        const auto channels = static_cast<std::size_t>(errors.channels);
        for (std::size_t i = 0; i < images.pixels.size(); ++i)
            for (std::size_t c = 0; c < colors; ++c) {
                const double s = errors.pixels[(is_one_value ? 0 : i * channels) + std::min(c, channels - 1)];
                sums[i * colors + c] += s * s;
            }
    }
    for (std::size_t i = 0; i < images.pixels.size(); ++i)
        for (std::size_t c = 0; c < colors; ++c) {
            const double error = rounding * static_cast<double>(images.reference_at(i)[c]);
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

NoiseScores score_noise(const AlignedImages& images, const std::vector<Image>& noise) {
    const auto colors = static_cast<std::size_t>(images.colors);
    const auto width = static_cast<std::size_t>(images.reference.width);
    const std::size_t columns = (width + noise_block - 1) / noise_block;
    const std::size_t rows =
        (static_cast<std::size_t>(images.reference.height) + noise_block - 1) / noise_block;
    const std::vector<double> variance = variances(images, noise);
    std::vector<Deviation> blocks(columns * rows * colors), totals(colors);

    NoiseScores scores;
    for (const double v : variance) scores.errors.push_back(static_cast<float>(std::sqrt(v)));
    scores.pixels.reserve(images.compared.size());
    for (const std::size_t i : images.compared) {
        double largest = 0.0;
        const std::size_t block = i / width / noise_block * columns + i % width / noise_block;
        for (std::size_t c = 0; c < colors; ++c) {
            const double difference =
                static_cast<double>(images.test_at(i)[c]) - static_cast<double>(images.reference_at(i)[c]);
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
        two_sided_z(chance / static_cast<double>(std::max<std::size_t>(images.compared.size(), 1))),
        two_sided_z(chance / static_cast<double>(columns * rows)), two_sided_z(chance)};
    return scores;
}

} // namespace sr::compare
