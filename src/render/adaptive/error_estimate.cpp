#include "render/adaptive/error_estimate.hpp"

#include "core/error.hpp"
#include "image/image.hpp"
#include "render/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace sr::render {
namespace {

double floor_of(const image::Image& mean) {
    std::vector<float> colors;
    colors.reserve(mean.pixels.size() / 4 * 3);
    for (std::size_t i = 0; i < mean.pixels.size(); ++i)
        if (i % 4 != 3 && std::isfinite(mean.pixels[i])) colors.push_back(mean.pixels[i]);
    return image::relative_floor(std::move(colors));
}

/// The square of a value that has two independent estimates, without the square of their errors: their
/// product. Of halves that know nothing of each other it says too little, so it is not less than a part of
/// the mean's square.
double square_of_value(double first, double second, double mean) {
    constexpr double min_ratio = 1.0 / 16.0;
    return std::max(first * second, min_ratio * mean * mean);
}

/// The expected square of one pixel's relative error.
double square_at(const float* mean, const float* first, int samples, double floor) {
    const double n_first = samples_of_half(0, samples), n_second = samples_of_half(1, samples);
    double sum = 0.0;
    for (int c = 0; c < 4; ++c) {
        const double m = mean[c], a = first[c];
        if (a == m) continue;
        const double b = (samples * m - n_first * a) / n_second;
        const double variance = n_first / n_second * (a - m) * (a - m); // of m; (a - b)²/4 if they are equal
        const double scale = c == 3 ? 1.0 : std::sqrt(square_of_value(a, b, m));
        sum += c == 3 ? variance : image::relative_square(std::sqrt(variance), scale, floor);
    }
    return std::isfinite(sum) ? sum / 4.0 : 0.0; // what is not finite is remarked on and no error of sampling
}

/// Means over blocks of the picture.
std::vector<double> block_means(const std::vector<float>& squares, int width, int height) {
    constexpr int side = 8;
    const int columns = (width + side - 1) / side, rows = (height + side - 1) / side;
    std::vector<double> sums(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0.0);
    std::vector<int> counts(sums.size(), 0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto block = static_cast<std::size_t>(y / side * columns + x / side);
            sums[block] += squares[static_cast<std::size_t>(y) * static_cast<std::size_t>(width)
                                   + static_cast<std::size_t>(x)];
            ++counts[block];
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= counts[i];
    return sums;
}

double standard_error(const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double sum = 0.0, squares = 0.0;
    for (const double value : values) {
        sum += value;
        squares += value * value;
    }
    const double mean = sum / count;
    return std::sqrt(std::max(0.0, squares / count - mean * mean) / count);
}

} // namespace

ErrorEstimate estimate_error(const image::Image& mean, const image::Image& first,
                             const std::vector<int>& samples) {
    require(mean.channels == 4 && first.pixels.size() == mean.pixels.size()
                && samples.size() * 4 == mean.pixels.size(),
            "two pictures of four channels, and a number for each pixel");
    ErrorEstimate estimate;
    estimate.floor = floor_of(mean);
    estimate.width = mean.width;
    estimate.height = mean.height;
    estimate.squares.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
        estimate.squares[i] = static_cast<float>(
            square_at(&mean.pixels[4 * i], &first.pixels[4 * i], samples[i], estimate.floor));
    sum_up(estimate);
    return estimate;
}

void sum_up(ErrorEstimate& estimate) {
    const double sum = std::accumulate(estimate.squares.begin(), estimate.squares.end(), 0.0);
    const double rel_mse = sum / static_cast<double>(estimate.squares.size());
    constexpr double allowance = 2.0; // standard errors
    const double uncertainty = standard_error(block_means(estimate.squares, estimate.width, estimate.height));
    estimate.expected = std::sqrt(rel_mse);
    estimate.error = std::sqrt(rel_mse + allowance * uncertainty);
}

} // namespace sr::render
