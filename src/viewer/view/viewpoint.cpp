#include "viewer/view/viewpoint.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {
namespace {

constexpr vec3 world_up{0.0f, 1.0f, 0.0f};
constexpr float min_distance = 1e-5f; // [m]: below, floats around the pivot run out of digits

quat turned(float angle, vec3 axis) { return glm::angleAxis(angle, axis); }

quat turn_of(vec3 right, vec3 up, vec3 back) { return glm::normalize(glm::quat_cast(mat3(right, up, back))); }

void keep_distance(Viewpoint& view) { view.distance = std::max(view.distance, min_distance); }

} // namespace

float Viewpoint::half_height() const { return distance * std::tan(0.5f * yfov); }

scene::LookAt look_at(const Viewpoint& view) {
    scene::LookAt description;
    description.eye = view.eye();
    description.target = view.pivot;
    description.up = view.up();
    description.yfov = view.yfov;
    if (view.is_orthographic) description.ymag = view.half_height();
    return description;
}

Viewpoint viewpoint_of(const scene::LookAt& description) {
    Viewpoint view;
    view.pivot = description.target;
    view.distance = glm::distance(description.eye, description.target);
    const vec3 back = (description.eye - description.target) / view.distance;
    const vec3 right = glm::normalize(glm::cross(description.up, back));
    view.turn = turn_of(right, glm::cross(back, right), back);
    view.is_orthographic = description.ymag.has_value();
    view.yfov = description.ymag ? 2.0f * std::atan(*description.ymag / view.distance) : description.yfov;
    keep_distance(view);
    return view;
}

Viewpoint viewpoint_of(const scene::Camera& camera, float aspect_ratio, vec3 center) {
    const mat4& m = camera.world_from_camera;
    const vec3 eye(m[3]), back(m[2]);
    Viewpoint view;
    view.turn = turn_of(vec3(m[0]), vec3(m[1]), back);
    const float along = glm::dot(eye - center, back);
    view.distance = std::max(along, 0.1f * std::max(glm::distance(eye, center), 0.1f));
    view.pivot = eye - view.distance * back;
    const float half = scene::half_extent(camera, aspect_ratio).y;
    view.is_orthographic = std::holds_alternative<scene::Orthographic>(camera.projection);
    view.yfov = 2.0f * std::atan(view.is_orthographic ? half / view.distance : half);
    return view;
}

void orbit(Viewpoint& view, vec2 angles) {
    // Upside down, the scene still follows the pointer.
    const float sign = view.up().y < 0.0f ? -1.0f : 1.0f;
    view.turn =
        glm::normalize(turned(-sign * angles.x, world_up) * view.turn * turned(-angles.y, vec3(1, 0, 0)));
}

void look_around(Viewpoint& view, vec2 angles) {
    const vec3 eye = view.eye();
    orbit(view, angles);
    view.pivot = eye - view.distance * view.back();
}

void pan(Viewpoint& view, vec2 by) {
    view.pivot += 2.0f * view.half_height() * (by.y * view.up() - by.x * view.right());
}

void dolly(Viewpoint& view, float factor) {
    view.distance *= factor;
    keep_distance(view);
}

void dolly_to(Viewpoint& view, float factor, vec3 point) {
    const float before = view.distance;
    dolly(view, factor);
    view.pivot = point + (view.distance / before) * (view.pivot - point);
}

void roll(Viewpoint& view, float angle) {
    view.turn = glm::normalize(view.turn * turned(angle, vec3(0, 0, 1)));
}

void level(Viewpoint& view) {
    const vec3 back = view.back();
    const vec3 right = glm::cross(world_up, back);
    constexpr float min_length = 1e-3f; // a view straight up or down has no level
    if (glm::length(right) < min_length) return;
    const vec3 unit = glm::normalize(right);
    view.turn = turn_of(unit, glm::cross(back, unit), back);
}

void walk(Viewpoint& view, vec3 by) { view.pivot += view.turn * by; }

void frame(Viewpoint& view, const scene::Bounds& bounds, float aspect_ratio) {
    if (bounds.is_empty()) return;
    const float half = std::atan(std::tan(0.5f * view.yfov) * std::min(1.0f, aspect_ratio));
    view.pivot = bounds.center();
    view.distance = bounds.radius() / std::sin(half);
    keep_distance(view);
}

void face(Viewpoint& view, Side side) {
    constexpr float quarter = 0.5f * pi;
    switch (side) {
    case Side::front: view.turn = quat(1, 0, 0, 0); return;
    case Side::back: view.turn = turned(pi, world_up); return;
    case Side::right: view.turn = turned(quarter, world_up); return;
    case Side::left: view.turn = turned(-quarter, world_up); return;
    case Side::top: view.turn = turned(-quarter, vec3(1, 0, 0)); return;
    case Side::bottom: view.turn = turned(quarter, vec3(1, 0, 0)); return;
    }
}

std::optional<vec2> projected(const scene::Camera& camera, float aspect_ratio, vec3 point) {
    const vec3 p(glm::inverse(camera.world_from_camera) * vec4(point, 1.0f));
    const vec2 half = scene::half_extent(camera, aspect_ratio);
    const bool is_perspective = std::holds_alternative<scene::Perspective>(camera.projection);
    if (is_perspective && p.z >= 0.0f) return std::nullopt;
    const vec2 flat = vec2(p) / (is_perspective ? -p.z : 1.0f) / half;
    return vec2(0.5f + 0.5f * flat.x, 0.5f - 0.5f * flat.y);
}

PickRay ray_through(const scene::Camera& camera, float aspect_ratio, vec2 place) {
    const mat4& m = camera.world_from_camera;
    const vec2 half = scene::half_extent(camera, aspect_ratio);
    const vec2 at = half * vec2(2.0f * place.x - 1.0f, 1.0f - 2.0f * place.y);
    if (std::holds_alternative<scene::Perspective>(camera.projection))
        return {vec3(m[3]), glm::normalize(vec3(m * vec4(at, -1.0f, 0.0f)))};
    return {vec3(m * vec4(at, 0.0f, 1.0f)), -vec3(m[2])};
}

} // namespace sr::viewer
