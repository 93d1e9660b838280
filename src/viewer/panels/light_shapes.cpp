#include "viewer/panels/light_shapes.hpp"

#include "core/math.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <limits>
#include <type_traits>
#include <variant>

namespace sr::viewer {
namespace {

constexpr int circle_steps = 48;
constexpr float outline_slack = 6.0f; // [pixels]

Polyline circle(vec3 center, vec3 u, vec3 v) {
    Polyline points;
    for (int i = 0; i <= circle_steps; ++i) {
        const float angle = 2.0f * pi * static_cast<float>(i) / circle_steps;
        points.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
    }
    return points;
}

/// Two unit vectors across a direction.
std::pair<vec3, vec3> perpendiculars(vec3 direction) {
    const vec3 u = glm::normalize(glm::cross(
        std::abs(direction.x) < 0.9f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f), direction));
    return {u, glm::cross(direction, u)};
}

/// The circle of a ball that the eye sees as its rim, nearly.
Polyline rim(vec3 center, float radius, vec3 eye) {
    const auto [u, v] = perpendiculars(glm::normalize(eye - center + vec3(1e-6f)));
    return circle(center, radius * u, radius * v);
}

void add_cone(LightShape& shape, vec3 tip, vec3 direction, float angle, float length, bool has_sides) {
    const auto [u, v] = perpendiculars(direction);
    const float radius = length * std::sin(angle);
    const vec3 base = tip + length * std::cos(angle) * direction;
    shape.reach.push_back(circle(base, radius * u, radius * v));
    if (!has_sides) return;
    for (const vec3 side : {u, -u, v, -v}) shape.reach.push_back({tip, base + radius * side});
}

struct ShapeMaker {
    LightShape& shape;
    float length;
    vec3 pivot;
    vec3 eye;

    void operator()(const scene::PointLight& light) const {
        if (light.radius > 0.0f) shape.outline.push_back(rim(light.position, light.radius, eye));
        if (std::isfinite(light.range)) shape.reach.push_back(rim(light.position, light.range, eye));
    }
    void operator()(const scene::SpotLight& light) const {
        if (light.radius > 0.0f) shape.outline.push_back(rim(light.position, light.radius, eye));
        const float reach = std::isfinite(light.range) ? light.range : 2.0f * length;
        add_cone(shape, light.position, light.direction, light.outer_angle, reach, true);
        if (light.inner_angle > 0.0f)
            add_cone(shape, light.position, light.direction, light.inner_angle, reach, false);
        shape.direction = {light.position, light.position + length * light.direction};
    }
    void operator()(const scene::DirectionalLight& light) const {
        const auto [u, v] = perpendiculars(light.direction);
        const vec3 from = pivot - 1.5f * length * light.direction;
        for (const vec3 side : {u, -u, v, -v}) {
            const vec3 beam = from + 0.3f * length * side;
            shape.outline.push_back({beam, beam + length * light.direction});
        }
        shape.outline.push_back(circle(from, 0.3f * length * u, 0.3f * length * v));
        shape.direction = {from, from + length * light.direction};
    }
    void operator()(const scene::RectangleLight& light) const {
        Polyline corners;
        for (const vec2 s : {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1), vec2(-1, -1)})
            corners.push_back(light.center + s.x * light.half_u + s.y * light.half_v);
        shape.outline.push_back(std::move(corners));
        shape.direction = {light.center, light.center + length * light.normal()};
    }
    void operator()(const scene::DiskLight& light) const {
        shape.outline.push_back(circle(light.center, light.half_u, light.half_v));
        shape.direction = {light.center, light.center + length * light.normal()};
    }
    void operator()(const scene::SphereLight& light) const {
        shape.outline.push_back(rim(light.center, light.radius, eye));
    }
    void operator()(const scene::TubeLight& light) const {
        const vec3 axis = glm::normalize(light.half_axis);
        const auto [u, v] = perpendiculars(axis);
        for (const float end : {-1.0f, 1.0f})
            shape.outline.push_back(
                circle(light.center + end * light.half_axis, light.radius * u, light.radius * v));
        const vec3 side = light.radius * glm::normalize(glm::cross(axis, eye - light.center) + 1e-6f * u);
        for (const float s : {-1.0f, 1.0f})
            shape.outline.push_back(
                {light.center - light.half_axis + s * side, light.center + light.half_axis + s * side});
    }
    void operator()(const scene::PolygonLight& light) const {
        Polyline corners = light.corners;
        if (!corners.empty()) corners.push_back(corners.front());
        shape.outline.push_back(std::move(corners));
    }
    void operator()(const scene::MeshLight&) const {}        // its surface is seen
    void operator()(const scene::EnvironmentLight&) const {} // it is everywhere
};

void draw_lines(const std::vector<Polyline>& lines, const Projection& projection, ImU32 color, float width) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (const Polyline& points : lines)
        for (std::size_t i = 1; i < points.size(); ++i) {
            const auto a = projection(points[i - 1]), b = projection(points[i]);
            if (a && b) list.AddLine({a->x, a->y}, {b->x, b->y}, color, width);
        }
}

void draw_arrow(const std::pair<vec3, vec3>& arrow, const Projection& projection, ImU32 color, float scale) {
    const auto a = projection(arrow.first), b = projection(arrow.second);
    if (!a || !b || glm::distance(*a, *b) < 1.0f) return;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const vec2 along = glm::normalize(*b - *a), side(-along.y, along.x);
    list.AddLine({a->x, a->y}, {b->x, b->y}, color, 2.0f * scale);
    const vec2 left = *b - 9.0f * scale * along + 5.0f * scale * side,
               right = *b - 9.0f * scale * along - 5.0f * scale * side;
    list.AddTriangleFilled({b->x, b->y}, {left.x, left.y}, {right.x, right.y}, color);
}

vec3 eye_of(const Projection& projection) { return vec3(projection.camera.world_from_camera[3]); }

} // namespace

LightShape shape_of(const scene::Light& light, float length, vec3 pivot, vec3 eye) {
    LightShape shape;
    std::visit(ShapeMaker{shape, length, pivot, eye}, light);
    return shape;
}

void draw_light_shapes(const LightEditor& lights, const LightSelection& selected,
                       std::optional<std::size_t> hovered, const Projection& projection, float length,
                       vec3 pivot, float scale) {
    constexpr ImU32 faint = IM_COL32(230, 159, 0, 150);
    for (std::size_t i = 0; i < lights.entries().size(); ++i) {
        const bool is_selected = selected.contains(i);
        if (!is_selected && i != hovered) continue;
        for (const scene::Light& light : lights.lights_of(i)) {
            const LightShape shape = shape_of(light, length, pivot, eye_of(projection));
            draw_lines(shape.outline, projection, is_selected ? palette::orange : palette::white,
                       2.0f * scale);
            if (!is_selected) continue;
            draw_lines(shape.reach, projection, faint, 1.0f * scale);
            if (shape.direction) draw_arrow(*shape.direction, projection, palette::orange, scale);
        }
    }
}

std::optional<std::size_t> outline_under(const LightEditor& lights, const Projection& projection,
                                         vec2 pointer) {
    std::optional<std::size_t> found;
    float nearest = outline_slack;
    for (std::size_t i = 0; i < lights.entries().size(); ++i) {
        const auto all = lights.lights_of(i);
        if (all.size() > 1 || std::holds_alternative<scene::DirectionalLight>(all.front())) continue;
        for (const Polyline& points : shape_of(all.front(), 1.0f, vec3(0.0f), eye_of(projection)).outline)
            for (std::size_t k = 1; k < points.size(); ++k) {
                const auto a = projection(points[k - 1]), b = projection(points[k]);
                const float d =
                    a && b ? distance_to_segment(pointer, *a, *b) : std::numeric_limits<float>::infinity();
                if (d > nearest) continue;
                nearest = d;
                found = i;
            }
    }
    return found;
}

} // namespace sr::viewer
