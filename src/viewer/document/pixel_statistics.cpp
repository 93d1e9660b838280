#include "viewer/document/pixel_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sr::viewer {
namespace {

constexpr double most_decades = 8.0; // of a histogram, below the brightest pixel

/// Calls act(red, green, blue, luminance) for each finite pixel. @return the number of the others
template<class Act>
std::size_t for_each_finite(const image::Image& film, const PixelRectangle& rectangle, Act act) {
    std::size_t others = 0;
    for (int y = rectangle.from.y; y < rectangle.end.y; ++y)
        for (int x = rectangle.from.x; x < rectangle.end.x; ++x) {
            const auto p = film.at(x, y);
            if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
                ++others;
            else
                act(glm::dvec4(p[0], p[1], p[2], luminance(p[0], p[1], p[2])));
        }
    return others;
}

} // namespace

PixelRectangle between(glm::ivec2 a, glm::ivec2 b, glm::ivec2 size) {
    const glm::ivec2 from = glm::clamp(glm::min(a, b), glm::ivec2(0), size);
    return {from, glm::clamp(glm::max(a, b) + 1, from, size)};
}

PixelStatistics statistics_of(const image::Image& film, const PixelRectangle& rectangle) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    PixelStatistics result;
    glm::dvec4 sum(0.0), least(infinity), most(-infinity);
    double squares = 0.0, darkest = infinity; // of lit pixels
    result.not_finite = for_each_finite(film, rectangle, [&](glm::dvec4 p) {
        ++result.count;
        sum += p;
        least = glm::min(least, p);
        most = glm::max(most, p);
        squares += p.w * p.w;
        if (p.w > 0.0) darkest = std::min(darkest, p.w);
    });
    if (result.count == 0) return result;
    const auto count = static_cast<double>(result.count);
    result.min = least;
    result.max = most;
    result.mean = sum / count;
    result.deviation = std::sqrt(std::max(0.0, squares / count - result.mean.w * result.mean.w));
    if (darkest < infinity) {
        result.last = std::ceil(std::log10(most.w));
        result.first =
            std::clamp(std::floor(std::log10(darkest)), result.last - most_decades, result.last - 1.0);
    }
    for_each_finite(film, rectangle, [&](glm::dvec4 p) {
        const double place =
            p.w > 0.0 ? (std::log10(p.w) - result.first) / (result.last - result.first) : 0.0;
        const double bin = std::floor(place * static_cast<double>(PixelStatistics::bins));
        ++result.histogram[static_cast<std::size_t>(
            std::clamp(bin, 0.0, static_cast<double>(PixelStatistics::bins - 1)))];
    });
    return result;
}

} // namespace sr::viewer
