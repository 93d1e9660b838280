#include "truth/comparison.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sr::truth {
namespace {

double quantile(std::vector<double> values, double q) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, place);
    return *place;
}

/// Mean over the sets of one value, and the variance of that mean.
std::pair<double, double> mean_and_variance(const std::vector<image::Image>& sets, std::size_t i) {
    const auto n = static_cast<double>(sets.size());
    double sum = 0.0, squares = 0.0;
    for (const image::Image& set : sets) sum += set.pixels[i];
    for (const image::Image& set : sets) squares += std::pow(set.pixels[i] - sum / n, 2.0);
    return {sum / n, squares / (n - 1.0) / n};
}

} // namespace

Measured measured(const std::vector<image::Image>& sets, int enlargement) {
    require(sets.size() > 1, "noise shows in two or more sets");
    const int width = sets[0].width / enlargement, height = sets[0].height / enlargement;
    const auto channels = static_cast<std::size_t>(sets[0].channels);
    const double share = 1.0 / (enlargement * enlargement); // of a small pixel in its large one
    Measured result{image::Image(width, height, 3), image::Image(width, height, 3)};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                double mean = 0.0, variance = 0.0;
                for (int part = 0; part < enlargement * enlargement; ++part) {
                    const int u = x * enlargement + part % enlargement,
                              v = y * enlargement + part / enlargement;
                    const auto [m, var] = mean_and_variance(
                        sets, static_cast<std::size_t>(v * sets[0].width + u) * channels + c);
                    mean += share * m;
                    variance += share * share * var;
                }
                result.mean.at(x, y)[c] = static_cast<float>(mean);
                result.noise.at(x, y)[c] = static_cast<float>(std::sqrt(variance));
            }
        }
    }
    return result;
}

image::Image reduced(const image::Image& film, int enlargement) {
    image::Image result(film.width / enlargement, film.height / enlargement, 3);
    const float share = 1.0f / static_cast<float>(enlargement * enlargement);
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                result.at(x / enlargement, y / enlargement)[c] += share * film.at(x, y)[c];
    return result;
}

Measured with_shared_noise(Measured picture) {
    const image::Image own = picture.noise;
    for (int y = 0; y < own.height; ++y) {
        for (int x = 0; x < own.width; ++x) {
            for (std::size_t c = 0; c < 3; ++c) {
                float sum = 0.0f, count = 0.0f;
                for (int v = std::max(y - 1, 0); v < std::min(y + 2, own.height); ++v)
                    for (int u = std::max(x - 1, 0); u < std::min(x + 2, own.width); ++u, ++count)
                        sum += own.at(u, v)[c] * own.at(u, v)[c];
                picture.noise.at(x, y)[c] = std::sqrt(sum / count);
            }
        }
    }
    return picture;
}

Distance distance(const Measured& ours, const Measured& reference) {
    Distance d;
    std::vector<double> relative, noise;
    double sums[2][3] = {}, variances[3] = {}, worst_of_pixel = 0.0;
    for (std::size_t i = 0; i < ours.mean.pixels.size(); ++i) {
        const double a = ours.mean.pixels[i], b = reference.mean.pixels[i];
        const double sigma = std::hypot(ours.noise.pixels[i], reference.noise.pixels[i]);
        const double off = std::abs(a - b);
        const double units = off == 0.0 ? 0.0 : off / sigma;
        require(std::isfinite(a), "the picture is finite");
        d.rms += units * units;
        worst_of_pixel = i % 3 == 0 ? units : std::max(worst_of_pixel, units);
        d.largest = std::max(d.largest, units);
        d.beyond_three += i % 3 == 2 && worst_of_pixel > 3.0;
        if (b > 0.0) {
            relative.push_back(off / b);
            noise.push_back(sigma / b);
        }
        sums[0][i % 3] += a;
        sums[1][i % 3] += b;
        variances[i % 3] += sigma * sigma;
    }
    for (int c = 0; c < 3; ++c) {
        d.energy = std::max(d.energy, std::abs(sums[0][c] / sums[1][c] - 1.0));
        d.energy_noise = std::max(d.energy_noise, std::sqrt(variances[c]) / sums[1][c]);
    }
    const auto values = static_cast<double>(ours.mean.pixels.size());
    d.beyond_three /= values / 3.0;
    d.rms = std::sqrt(d.rms / values);
    d.median = quantile(relative, 0.5);
    d.p95 = quantile(relative, 0.95);
    d.noise = quantile(noise, 0.5);
    return d;
}

} // namespace sr::truth
