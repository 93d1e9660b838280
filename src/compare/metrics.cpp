#include "compare/metrics.hpp"

#include "image/image.hpp"

#include <algorithm>
#include <cmath>

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

std::vector<double> channel_floors(const AlignedImages& images) {
    std::vector<double> floors;
    for (std::size_t c = 0; c < static_cast<std::size_t>(images.colors); ++c) {
        std::vector<float> values;
        for (const std::size_t i : images.compared) values.push_back(images.reference_at(i)[c]);
        const double floor = image::relative_floor(std::move(values));
        floors.push_back(floor > 0.0 ? floor : relative_floor(images));
    }
    return floors;
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

PixelValues relative_differences(const AlignedImages& images, std::span<const double> floors) {
    PixelValues values;
    values.reserve(images.compared.size());
    for (const std::size_t i : images.compared) {
        const auto t = images.test_at(i), r = images.reference_at(i);
        double largest = 0.0;
        for (std::size_t c = 0; c < r.size(); ++c) {
            const bool is_color = static_cast<int>(c) < images.colors;
            const double scale = is_color ? std::max(std::abs(static_cast<double>(r[c])), floors[c]) : 1.0;
            largest =
                std::max(largest, relative(static_cast<double>(t[c]) - static_cast<double>(r[c]), scale));
        }
        values.push_back(static_cast<float>(largest));
    }
    return values;
}

std::vector<double> energy_ratios(const AlignedImages& images, const std::vector<bool>& left_out) {
    std::vector<double> ratios;
    for (std::size_t c = 0; c < static_cast<std::size_t>(images.colors); ++c) {
        double difference = 0.0, reference = 0.0;
        for (std::size_t k = 0; k < images.compared.size(); ++k) {
            if (left_out[k]) continue;
            const double t = images.test_at(images.compared[k])[c],
                         r = images.reference_at(images.compared[k])[c];
            difference += t - r;
            reference += std::abs(r);
        }
        ratios.push_back(difference == 0.0 ? 1.0 : 1.0 + difference / reference);
    }
    return ratios;
}

void measure_differences(const AlignedImages& images, Metrics& metrics) {
    metrics.pixels = images.compared.size();
    metrics.nonfinite_test = images.nonfinite_test;
    metrics.nonfinite_reference = images.nonfinite_reference;
    if (images.compared.empty()) return;
    metrics.floor = relative_floor(images);
    metrics.max_abs = std::ranges::max(absolute_differences(images));
    const std::vector<double> floors(static_cast<std::size_t>(images.colors), metrics.floor);
    metrics.max_rel = std::ranges::max(relative_differences(images, floors));
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

Density densest_window(const AlignedImages& images, const std::vector<bool>& fails, int edge) {
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

    const std::size_t w = std::min(static_cast<std::size_t>(edge), width);
    const std::size_t h = std::min(static_cast<std::size_t>(edge), height);
    int most = 0;
    for (std::size_t y = h; y <= height; ++y)
        for (std::size_t x = w; x <= width; ++x)
            most = std::max(most, sums[y * stride + x] - sums[(y - h) * stride + x] - sums[y * stride + x - w]
                                      + sums[(y - h) * stride + x - w]);
    return {most, static_cast<double>(most) / static_cast<double>(w * h)};
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

} // namespace sr::compare
