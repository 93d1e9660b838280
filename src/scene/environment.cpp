#include "scene/environment.hpp"

#include "core/error.hpp"
#include "core/math.hpp"

#include <algorithm>
#include <cmath>

namespace sr::scene {
namespace {

/// The cumulative sums of `weights` over their total, the last of which with a weight and all behind it are
/// exactly 1; all zero without weights.
template<class Weights>
void append_cdf(const Weights& weights, std::vector<float>& cdf) {
    double total = 0.0;
    for (const double weight : weights) total += weight;
    double sum = 0.0;
    for (const double weight : weights) {
        sum += weight;
        cdf.push_back(total > 0.0 ? static_cast<float>(sum / total) : 0.0f);
    }
    if (!(total > 0.0)) return;
    auto last = weights.size();
    while (last > 0 && !(weights[last - 1] > 0.0)) --last;
    std::fill(cdf.end() - static_cast<std::ptrdiff_t>(weights.size() - last + 1), cdf.end(), 1.0f);
}

/// Returns the entry of an ascending cdf that u falls on. Sets u to its place within that entry, 0 to 1.
int entry_at(const float* cdf, int count, float& u) {
    const int i = std::min(static_cast<int>(std::upper_bound(cdf, cdf + count, u) - cdf), count - 1);
    const float low = i > 0 ? cdf[i - 1] : 0.0f;
    u = std::clamp((u - low) / (cdf[i] - low), 0.0f, 1.0f);
    return i;
}

/// Returns the probability of entry i: its cdf less that of the entry before.
double share(const float* cdf, int i) {
    return static_cast<double>(cdf[i]) - (i > 0 ? static_cast<double>(cdf[i - 1]) : 0.0);
}

} // namespace

EnvironmentMap::EnvironmentMap(int width, int height, std::vector<vec3> texels)
    : width_(width), height_(height), texels_(std::move(texels)) {
    require(width > 0 && height > 0
                && texels_.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
            "an environment has as many texels as its size says");
    build_tables();
}

void EnvironmentMap::build_tables() {
    std::vector<double> rows;
    std::vector<double> row(static_cast<std::size_t>(width_));
    glm::dvec3 sum(0.0);
    texel_cdf_.reserve(texels_.size());
    for (int j = 0; j < height_; ++j) {
        double total = 0.0;
        for (int i = 0; i < width_; ++i) {
            // The mean of a bilinear function over a texel: 1, 6, 1 over 8 in each direction.
            glm::dvec3 mean(0.0);
            for (int dj = -1; dj <= 1; ++dj)
                for (int di = -1; di <= 1; ++di)
                    mean += (di == 0 ? 0.75 : 0.125) * (dj == 0 ? 0.75 : 0.125)
                            * glm::dvec3(texel(i + di, j + dj));
            row[static_cast<std::size_t>(i)] = sr::luminance(mean);
            total += sr::luminance(mean);
            sum += mean * solid_angle(j);
        }
        append_cdf(row, texel_cdf_);
        rows.push_back(total * solid_angle(j));
    }
    append_cdf(rows, row_cdf_);
    mean_ = vec3(sum / (4.0 * glm::pi<double>()));
}

double EnvironmentMap::solid_angle(int j) const {
    const double step = glm::pi<double>() / height_;
    // cos(j step) - cos((j + 1) step), which does not cancel at the poles
    const double height = 2.0 * std::sin((j + 0.5) * step) * std::sin(0.5 * step);
    return height * 2.0 * glm::pi<double>() / width_;
}

vec2 EnvironmentMap::pole_heights(int j) const {
    const double step = glm::pi<double>() / height_;
    const auto height = [](double angle) { return 2.0 * std::sin(0.5 * angle) * std::sin(0.5 * angle); };
    if (2 * j < height_) return {height(j * step), height((j + 1) * step)};
    return {height((height_ - j) * step), height((height_ - j - 1) * step)};
}

vec3 EnvironmentMap::texel(int i, int j) const {
    const int column = (i % width_ + width_) % width_;
    const int row = std::clamp(j, 0, height_ - 1);
    return texels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_)
                   + static_cast<std::size_t>(column)];
}

vec2 EnvironmentMap::place_of(vec3 w) {
    const float around = std::atan2(w.x, -w.z) / (2.0f * pi) + 0.5f;
    return {around, std::atan2(std::hypot(w.x, w.z), w.y) / pi};
}

vec3 EnvironmentMap::direction_of(vec2 place) {
    const float phi = 2.0f * pi * (place.x - 0.5f), theta = pi * place.y;
    return {std::sin(theta) * std::sin(phi), std::cos(theta), -std::sin(theta) * std::cos(phi)};
}

vec3 EnvironmentMap::radiance(vec3 w) const {
    const vec2 at = place_of(w) * vec2(width_, height_) - 0.5f;
    const vec2 corner = glm::floor(at);
    const vec2 f = at - corner;
    const int i = static_cast<int>(corner.x), j = static_cast<int>(corner.y);
    return glm::mix(glm::mix(texel(i, j), texel(i + 1, j), f.x),
                    glm::mix(texel(i, j + 1), texel(i + 1, j + 1), f.x), f.y);
}

double EnvironmentMap::density(vec3 w) const {
    const vec2 place = place_of(w) * vec2(width_, height_);
    const int i = std::clamp(static_cast<int>(place.x), 0, width_ - 1);
    const int j = std::clamp(static_cast<int>(place.y), 0, height_ - 1);
    const float* texels = &texel_cdf_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_)];
    return share(row_cdf_.data(), j) * share(texels, i) / solid_angle(j);
}

vec3 EnvironmentMap::sample(vec2 u) const {
    require(has_light(), "an environment without light is not sampled");
    const int j = entry_at(row_cdf_.data(), height_, u.y);
    const int i =
        entry_at(&texel_cdf_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_)], width_, u.x);
    const vec2 heights = pole_heights(j);
    const float height = glm::mix(heights.x, heights.y, u.y);
    const float y = 2 * j < height_ ? 1.0f - height : height - 1.0f;
    const float across = std::sqrt(height * (2.0f - height));
    const float phi = 2.0f * pi * ((static_cast<float>(i) + u.x) / static_cast<float>(width_) - 0.5f);
    return {across * std::sin(phi), y, -across * std::cos(phi)};
}

} // namespace sr::scene
