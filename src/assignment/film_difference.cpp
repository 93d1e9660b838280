#include "assignment/film_difference.hpp"

#include "golden/page.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <cmath>

namespace sr::assignment {

using nlohmann::ordered_json;

namespace {

constexpr double visible_change = 0.01; // of a value, relative

} // namespace

vec3 rgb_at(const image::Image& film, int x, int y) {
    const auto p = film.at(x, y);
    return {p[0], p[1], p[2]};
}

bool differs(double a, double b, double floor) {
    if (!std::isfinite(a) || !std::isfinite(b)) return std::isfinite(a) != std::isfinite(b);
    return std::abs(a - b) > visible_change * std::max({std::abs(a), std::abs(b), floor});
}

bool differs(vec3 a, vec3 b, double floor) {
    return differs(a.x, b.x, floor) || differs(a.y, b.y, floor) || differs(a.z, b.z, floor);
}

double mean_of(const image::Image& film) {
    double sum = 0.0, count = 0.0;
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x)
            if (const double L = luminance(rgb_at(film, x, y)); std::isfinite(L)) {
                sum += L;
                count += 1.0;
            }
    return count > 0.0 ? sum / count : 0.0;
}

ordered_json difference_of(const image::Image& before, const image::Image& after) {
    const double mean = mean_of(before);
    int count = 0, at_x = 0, at_y = 0;
    double most = 0.0;
    for (int y = 0; y < before.height; ++y)
        for (int x = 0; x < before.width; ++x) {
            const vec3 a = rgb_at(before, x, y), b = rgb_at(after, x, y);
            if (!differs(a, b, 0.01 * mean)) continue;
            ++count;
            double change = std::abs(luminance(b) - luminance(a));
            if (!std::isfinite(change)) change = 1e30;
            if (change > most) {
                most = change;
                at_x = x;
                at_y = y;
            }
        }
    const vec3 a = rgb_at(before, at_x, at_y), b = rgb_at(after, at_x, at_y);
    return {{"mean_before", mean},
            {"mean_after", mean_of(after)},
            {"changed", static_cast<double>(count) / (before.width * before.height)},
            {"pixel", {at_x, at_y}},
            {"before", {a.x, a.y, a.z}},
            {"after", {b.x, b.y, b.z}}};
}

bool is_between_once_and_twice(const image::Image& before, const image::Image& after) {
    const double floor = 1e-4 * mean_of(before);
    for (int y = 0; y < before.height; ++y)
        for (int x = 0; x < before.width; ++x) {
            const double a = luminance(rgb_at(before, x, y)), b = luminance(rgb_at(after, x, y));
            if (!(b >= 0.999 * a - floor && b <= 2.001 * a + floor)) return false;
        }
    return true;
}

std::string png_of(const image::Image& film, const image::Image& exposed,
                   std::optional<std::pair<int, int>> marked) {
    constexpr int half = 4; // of the frame [pixels]
    image::Image shown = image::displayed(film, image::auto_ev100(exposed));
    for (int j = -half; marked && j <= half; ++j)
        for (int i = -half; i <= half; ++i) {
            const int x = marked->first + i, y = marked->second + j;
            const bool is_inside = x >= 0 && y >= 0 && x < shown.width && y < shown.height;
            if (std::max(std::abs(i), std::abs(j)) != half || !is_inside) continue;
            const auto p = shown.at(x, y);
            p[0] = 1.0f;
            p[1] = p[2] = 0.1f;
        }
    return golden::png_data(shown);
}

} // namespace sr::assignment
