#include "golden/differences.hpp"

#include "image/relative_error.hpp"

#include <algorithm>
#include <cmath>

namespace sr::golden {
namespace {

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

Sums summed(const Pair& pair, std::size_t channel, double floor) {
    const bool is_color = static_cast<int>(channel) < pair.colors;
    Sums sums;
    for (const std::size_t i : pair.compared) {
        const double t = pair.test_at(i)[channel], r = pair.reference_at(i)[channel], d = t - r;
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

double relative_floor(const Pair& pair) {
    std::vector<float> colors;
    for (const std::size_t i : pair.compared) {
        const auto r = pair.reference_at(i).first(static_cast<std::size_t>(pair.colors));
        colors.insert(colors.end(), r.begin(), r.end());
    }
    return image::relative_floor(std::move(colors));
}

PixelValues absolute_differences(const Pair& pair) {
    PixelValues values;
    values.reserve(pair.compared.size());
    for (const std::size_t i : pair.compared) {
        const auto t = pair.test_at(i), r = pair.reference_at(i);
        float largest = 0.0f;
        for (std::size_t c = 0; c < r.size(); ++c) largest = std::max(largest, std::abs(t[c] - r[c]));
        values.push_back(largest);
    }
    return values;
}

PixelValues relative_differences(const Pair& pair, double floor) {
    PixelValues values;
    values.reserve(pair.compared.size());
    for (const std::size_t i : pair.compared) {
        const auto t = pair.test_at(i), r = pair.reference_at(i);
        double largest = 0.0;
        for (std::size_t c = 0; c < r.size(); ++c) {
            const bool is_color = static_cast<int>(c) < pair.colors;
            const double scale = is_color ? std::max(std::abs(static_cast<double>(r[c])), floor) : 1.0;
            largest =
                std::max(largest, relative(static_cast<double>(t[c]) - static_cast<double>(r[c]), scale));
        }
        values.push_back(static_cast<float>(largest));
    }
    return values;
}

void measure_differences(const Pair& pair, Metrics& metrics) {
    metrics.pixels = pair.compared.size();
    metrics.nonfinite_test = pair.nonfinite_test;
    metrics.nonfinite_reference = pair.nonfinite_reference;
    if (pair.compared.empty()) return;
    metrics.floor = relative_floor(pair);
    metrics.max_abs = std::ranges::max(absolute_differences(pair));
    metrics.max_rel = std::ranges::max(relative_differences(pair, metrics.floor));
    Sums all;
    for (std::size_t c = 0; c < static_cast<std::size_t>(pair.reference.channels); ++c) {
        const Sums sums = summed(pair, c, metrics.floor);
        all.abs += sums.abs;
        all.rel += sums.rel;
        all.square += sums.square;
        all.relative_square += sums.relative_square;
        if (pair.colors == 1 && c == 0) metrics.energy_ratio.fill(ratio(sums.test, sums.reference));
        if (pair.colors == 3 && c < 3) metrics.energy_ratio[c] = ratio(sums.test, sums.reference);
    }
    const auto count = static_cast<double>(pair.compared.size()) * pair.reference.channels;
    metrics.mean_abs = all.abs / count;
    metrics.mean_rel = all.rel / count;
    metrics.rmse = std::sqrt(all.square / count);
    metrics.rel_mse = all.relative_square / count;
}

} // namespace sr::golden
