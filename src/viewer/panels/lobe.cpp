#include "viewer/panels/lobe.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {
namespace {

vec3 perpendicular_to(vec3 w) {
    const vec3 axis = std::abs(w.x) < 0.7f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
    return glm::normalize(glm::cross(w, axis));
}

/// The unit vector across w that is nearest to v; any across w where v is along it.
vec3 across_towards(vec3 w, vec3 v) {
    const vec3 rest = v - glm::dot(v, w) * w;
    constexpr float rounding = 1e-5f; // of what is left of two unit vectors
    return glm::length(rest) > rounding ? glm::normalize(rest) : perpendicular_to(w);
}

/// Returns the place of a point on its meridian: a thousandth of the way at first, then geometrically
/// farther.
float share(std::size_t point) {
    constexpr float steepness = 5.0f;
    const float t = static_cast<float>(point) / LobeGrid::points;
    return std::expm1(steepness * t) / std::expm1(steepness);
}

} // namespace

std::vector<vec3> lobe_directions(vec3 n, vec3 wo) {
    const vec3 m = glm::normalize(2.0f * glm::dot(n, wo) * n - wo);
    const vec3 over_n = across_towards(m, n), aside = glm::cross(m, over_n);
    constexpr float inside = 511.0f / 512.0f; // of the way to the horizon, where cosθ_i is 0
    std::vector<vec3> directions{m};
    for (std::size_t meridian = 0; meridian < LobeGrid::meridians; ++meridian) {
        const float azimuth = 2.0f * pi * static_cast<float>(meridian) / LobeGrid::meridians;
        const vec3 along = std::cos(azimuth) * over_n + std::sin(azimuth) * aside;
        const float horizon = std::atan2(std::max(glm::dot(m, n), 0.0f), -glm::dot(along, n));
        for (std::size_t point = 1; point <= LobeGrid::points; ++point) {
            const float angle = inside * share(point) * horizon;
            directions.push_back(std::cos(angle) * m + std::sin(angle) * along);
        }
    }
    return directions;
}

float shown_value(const Lobe& lobe, vec3 wi, float f_r, const LobeSettings& look) {
    const float cos_i = std::max(glm::dot(lobe.n, wi), 0.0f);
    if (!std::isfinite(f_r) || cos_i == 0.0f) return 0.0f;
    return std::max(0.0f, look.has_cosine ? f_r * cos_i : f_r);
}

LobeScale scale_of(const Lobe& lobe, const LobeSettings& look) {
    std::vector<float> values;
    for (std::size_t i = 0; i < lobe.wi.size(); ++i)
        if (const float value = shown_value(lobe, lobe.wi[i], lobe.f_r[i], look); value > 0.0f)
            values.push_back(value);
    if (values.empty()) return {};
    std::ranges::sort(values);
    const float largest = values.back();
    if (!look.is_logarithmic) return {largest, 0.0f};
    constexpr float min_decades = 2.0f, max_decades = 12.0f;
    return {largest, std::clamp(std::ceil(std::log10(largest / values[values.size() / 2])) + 1.0f,
                                min_decades, max_decades)};
}

float shown_radius(float value, const LobeScale& scale) {
    if (!(value > 0.0f && scale.largest > 0.0f)) return 0.0f;
    const float part = std::min(value / scale.largest, 1.0f);
    return scale.decades > 0.0f ? std::max(0.0f, 1.0f + std::log10(part) / scale.decades) : part;
}

float plane_angle(const Lobe& lobe, vec3 wi) {
    const vec3 side = -across_towards(lobe.n, lobe.wo);
    const float theta = std::acos(std::clamp(glm::dot(lobe.n, wi), -1.0f, 1.0f));
    return std::copysign(theta, glm::dot(side, wi));
}

} // namespace sr::viewer
