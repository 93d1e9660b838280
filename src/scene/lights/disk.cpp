#include "scene/lights/disk.hpp"

#include "scene/lights/emitter.hpp"

#include <cmath>

namespace sr::scene {

std::span<const Dimension<DiskLight>> DiskLight::sizes() const {
    const float u = glm::length(half_u), v = glm::length(half_v);
    if (std::abs(u - v) <= 1e-5f * u) return of_circle;
    return of_ellipse;
}

Radiator DiskLight::radiator() const { return flat_radiator(*this, pi64 * parallelogram(half_u, half_v)); }

Bounds DiskLight::bounds() const { return box_around(center, glm::abs(half_u) + glm::abs(half_v)); }

void DiskLight::transform(const Motion& by) {
    center = by.place(center);
    half_u = by.linear * half_u;
    half_v = by.linear * half_v;
}

std::optional<LightSurface> DiskLight::surface() const {
    std::vector<vec2> st;
    for (int i = 0; i < corners_around; ++i) st.push_back(on_circle(i, corners_around));
    return flat_surface(*this, st);
}

EmitterPoint DiskLight::sample_point(vec3 u) const { return point_on_plane(*this, in_disk(vec2(u))); }

} // namespace sr::scene
