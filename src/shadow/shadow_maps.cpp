#include "shadow/shadow_maps.hpp"

#include <algorithm>
#include <cmath>

namespace sr::shadow {
namespace {

constexpr float widest = 1.7320508f; // tan 60°: beyond, a face of a cube has finer texels

bool is_finite(vec3 p) {
    return std::abs(p.x) < 1.8e18f && std::abs(p.y) < 1.8e18f && std::abs(p.z) < 1.8e18f;
}

/// A right-handed frame whose last axis is `forward`, turned by `roll`.
mat3 frame_along(vec3 forward, float roll) {
    const vec3 slanted = std::abs(forward.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0);
    const vec3 u = glm::normalize(glm::cross(slanted, forward));
    const vec3 v = glm::cross(forward, u);
    const vec3 turned = std::cos(roll) * u + std::sin(roll) * v;
    return {turned, glm::cross(forward, turned), forward};
}

/// A direction along which light goes, and the tangent of the half angle of the cone that it fills.
struct Cone {
    vec3 axis{0.0f};
    float tangent = INFINITY;
};

Cone cone_of(const Ball& ball, vec3 from) {
    const vec3 to_center = ball.center - from;
    const float d2 = glm::dot(to_center, to_center), r2 = ball.radius * ball.radius;
    if (!(d2 > r2)) return {};
    return {to_center / std::sqrt(d2), std::sqrt(r2 / (d2 - r2))};
}

Cone narrower(const Cone& a, const Cone& b) { return b.tangent < a.tangent ? b : a; }

/// d as a face sees it: (u, v) and the distance along it.
vec3 in_face(const MapView& view, int face, vec3 d) {
    const int axis = face / 2;
    const float side = face % 2 == 0 ? 1.0f : -1.0f;
    return {glm::dot(view.axes[(axis + 1) % 3], d), glm::dot(view.axes[(axis + 2) % 3], d),
            side * glm::dot(view.axes[axis], d)};
}

} // namespace

Ball ball_around(std::span<const vec3> points) {
    vec3 low(INFINITY), high(-INFINITY);
    for (const vec3 p : points) {
        if (!is_finite(p)) continue;
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    if (!(low.x <= high.x)) return {};
    Ball ball{0.5f * (low + high), 0.0f};
    for (const vec3 p : points)
        if (is_finite(p)) ball.radius = std::max(ball.radius, glm::distance(p, ball.center));
    return ball;
}

Ball ball_around(std::span<const Ball> balls) {
    vec3 low(INFINITY), high(-INFINITY);
    for (const Ball& ball : balls) {
        if (ball.radius < 0.0f) continue;
        low = glm::min(low, ball.center - ball.radius);
        high = glm::max(high, ball.center + ball.radius);
    }
    if (!(low.x <= high.x)) return {};
    Ball all{0.5f * (low + high), 0.0f};
    for (const Ball& ball : balls)
        if (ball.radius >= 0.0f)
            all.radius = std::max(all.radius, glm::distance(ball.center, all.center) + ball.radius);
    return all;
}

bool MapView::has_face(int face) const {
    if (kind != MapKind::cube) return face == forward_face;
    return !is_half || face != forward_face + 1;
}

MapView view_from(const scene::EmitterPoint& point, const scene::Light& light, const Ball& receivers,
                  const Ball& casters, float roll, int size) {
    MapView view;
    view.origin = point.place;
    const float guard =
        1.0f - 4.0f / static_cast<float>(size); // two texels beyond what is looked up, on all sides
    if (point.is_far) {
        view.kind = MapKind::orthographic;
        view.origin = receivers.center;
        view.axes = frame_along(-point.place, roll);
        view.scale = guard / std::max(receivers.radius, 1e-30f); // 1e-30: a scene without extent
        view.far = std::max(casters.radius + glm::distance(casters.center, view.origin), 1e-30f);
        return view;
    }
    view.far = 1.01f * (glm::distance(casters.center, point.place) + casters.radius); // 1.01: rounding
    Cone cone = cone_of(receivers, point.place);
    const auto* spot = std::get_if<scene::SpotLight>(&light);
    if (spot && !(spot->radius > 0.0f) && spot->outer_angle < 1.0f)
        cone = narrower(cone, {spot->direction, std::tan(spot->outer_angle)});
    if (cone.tangent < widest) {
        view.kind = MapKind::perspective;
        view.axes = frame_along(cone.axis, roll);
        view.scale = guard / std::max(cone.tangent, 1e-30f);
        return view;
    }
    view.is_half = point.normal != vec3(0.0f) && !point.is_two_sided;
    view.axes = frame_along(view.is_half ? point.normal : vec3(0, 1, 0), roll);
    view.scale = guard;
    return view;
}

mat4 clip_from_world(const MapView& view, int face) {
    const int axis = face / 2;
    const float side = face % 2 == 0 ? 1.0f : -1.0f;
    const vec3 u = view.scale * view.axes[(axis + 1) % 3];
    const vec3 v = view.scale * view.axes[(axis + 2) % 3];
    const vec3 w = side * view.axes[axis] / view.far;
    const auto row = [&](vec3 r, float at_origin) { return vec4(r, at_origin - glm::dot(r, view.origin)); };
    if (view.kind == MapKind::orthographic)
        return glm::transpose(mat4(row(u, 0.0f), row(v, 0.0f), row(w, 0.0f), vec4(0, 0, 0, 1)));
    // z = w - 2 near: nothing is cut off at the far end. The shader writes depth itself, so that a near end
    // so close costs no precision.
    constexpr float near = 1e-6f; // of far
    return glm::transpose(
        mat4(row(u / view.far, 0.0f), row(v / view.far, 0.0f), row(w, -2.0f * near), row(w, 0.0f)));
}

bool may_see(const MapView& view, int face, const Ball& ball) {
    if (ball.radius < 0.0f) return false;
    const vec3 d = in_face(view, face, ball.center - view.origin);
    const float most = std::max(std::abs(d.x), std::abs(d.y));
    if (view.kind == MapKind::orthographic) return most - ball.radius <= 1.0f / view.scale;
    // Signed distances from the face's planes through the point.
    return d.z >= -ball.radius
           && most * view.scale - d.z <= ball.radius * std::sqrt(1.0f + view.scale * view.scale);
}

namespace {

bool reflects(const scene::Material& material) {
    const bool is_black =
        vec3(material.base_color) == vec3(0.0f) && !material.base_color_texture.is_present();
    return !material.is_unlit && !(is_black && material.specular == 0.0f && !material.transmits_diffusely());
}

} // namespace

bool stands_in_light(const Caster& caster, int light) {
    return !(caster.emits_as.contains(light) && caster.own_share == whole_ray);
}

bool is_in_maps(const Caster& caster, int light) {
    return caster.glass < 0 && stands_in_light(caster, light);
}

ShadowMapScene map_stage_of(const scene::Scene& scene, std::span<const scene::Light> lights,
                            const Casters& casters) {
    ShadowMapScene stage;
    stage.lights.assign(lights.begin(), lights.end());
    for (std::size_t i = 0; i < casters.casters.size(); ++i) {
        const auto first = 3 * static_cast<std::size_t>(casters.casters[i].first_triangle);
        const std::size_t end = i + 1 < casters.casters.size()
                                    ? 3 * static_cast<std::size_t>(casters.casters[i + 1].first_triangle)
                                    : casters.corners.size();
        stage.casters.push_back(ball_around(std::span(casters.corners).subspan(first, end - first)));
    }
    stage.all = ball_around(stage.casters);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        std::vector<Ball> receivers;
        for (std::size_t i = 0; i < stage.casters.size(); ++i) {
            const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)];
            if (reflects(scene.materials[static_cast<std::size_t>(mesh.material)])
                && stands_in_light(casters.casters[i], static_cast<int>(k)))
                receivers.push_back(stage.casters[i]);
        }
        stage.receivers.push_back(ball_around(receivers));
    }
    return stage;
}

} // namespace sr::shadow
