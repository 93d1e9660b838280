#include "scene/lights/rectangle.hpp"

#include "scene/lights/emitter.hpp"

namespace sr::scene {

Radiator RectangleLight::radiator() const {
    return flat_radiator(*this, 4.0 * parallelogram(half_u, half_v));
}

Bounds RectangleLight::bounds() const { return box_around(center, glm::abs(half_u) + glm::abs(half_v)); }

void RectangleLight::transform(const Motion& by) {
    center = by.place(center);
    half_u = by.linear * half_u;
    half_v = by.linear * half_v;
}

std::optional<LightSurface> RectangleLight::surface() const {
    return flat_surface(*this, {{-1.0f, -1.0f}, {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}});
}

EmitterPoint RectangleLight::sample_point(vec3 u) const {
    return point_on_plane(*this, 2.0f * vec2(u) - 1.0f);
}

} // namespace sr::scene
