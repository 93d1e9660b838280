#include "shadow/origin.hpp"

#include <algorithm>
#include <limits>

namespace sr::shadow {
namespace {

constexpr float offset_share = 1.0f / 131072.0f;     // 2^-17
constexpr float last_share = 1.0f - 1.0f / 32768.0f; // 1 - 2^-15

float largest(vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// From `origin` to where the query looks.
Ray ray_from(vec3 origin, const Query& query) {
    if (query.is_infinite) return {origin, query.to_emitter, std::numeric_limits<float>::infinity()};
    return {origin, query.x + query.to_emitter - origin, last_share};
}

} // namespace

Ray ray_from_line(const Query& query) {
    const vec3 wi = glm::normalize(query.to_emitter);
    return ray_from(query.x + offset_share * largest(query.x) * wi, query);
}

Ray ray_of(const Query& query, std::span<const vec3, 3> triangle) {
    const vec3 a = triangle[0];
    vec3 n = glm::cross(triangle[1] - a, triangle[2] - a);
    const float length = glm::length(n);
    n = length > 0.0f ? n / length : vec3(0.0f);
    const float reach = std::max({largest(a), largest(triangle[1]), largest(triangle[2])});
    const float side = glm::dot(n, query.to_emitter) < 0.0f ? -1.0f : 1.0f;
    return ray_from(query.x + (side * offset_share * reach - glm::dot(query.x - a, n)) * n, query);
}

} // namespace sr::shadow
