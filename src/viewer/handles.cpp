#include "viewer/handles.hpp"

#include "viewer/palette.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace sr::viewer {
namespace {

constexpr float slack = 6.0f;         // a pointer may miss by so many pixels
constexpr float arrow_length = 70.0f; // [pixels]
constexpr float square = 5.0f;        // half its side [pixels]
constexpr float nearest = 14.0f;      // squares nearer to the centre would hide it [pixels]
constexpr int ring_steps = 64;

std::vector<vec2> ring(vec3 center, int axis, const Projection& projection, float radius) {
    const vec3 eye(projection.camera.world_from_camera[3]);
    const bool is_flat = std::holds_alternative<scene::Orthographic>(projection.camera.projection);
    const vec3 view = is_flat ? vec3(projection.camera.world_from_camera[2]) : eye - center;
    vec3 u(0.0f), v(0.0f);
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1.0f;
    // The half that faces the eye, from one of its ends to the other.
    const float first = std::atan2(glm::dot(v, view), glm::dot(u, view)) - 0.5f * pi;
    std::vector<vec2> points;
    for (int i = 0; i <= ring_steps; ++i) {
        const float angle = first + pi * static_cast<float>(i) / ring_steps;
        if (const auto at = projection(center + radius * (std::cos(angle) * u + std::sin(angle) * v)))
            points.push_back(*at);
    }
    return points;
}

float distance_to(vec2 p, const std::vector<vec2>& line) {
    float least = 1e30f;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        least = std::min(least, distance_to_segment(p, line[i], line[i + 1]));
    return least;
}

constexpr std::array letters{"X", "Y", "Z"};

} // namespace

Handles handles_of(const std::vector<scene::LightSize>& extents, vec3 center, bool moves,
                   const Projection& projection, float scale) {
    Handles handles;
    const auto at = projection(center);
    const auto radius = metres_of(center, projection, ring_radius * scale);
    if (!at || !radius) return handles;
    for (int axis = 0; axis < 3; ++axis)
        handles.rings[static_cast<std::size_t>(axis)] = ring(center, axis, projection, *radius);
    if (!moves) return handles;
    if (const auto arrows = arrows_at(center, projection, arrow_length * scale))
        handles.arrows.assign(arrows->begin(), arrows->end());
    const mat4& camera = projection.camera.world_from_camera;
    const vec3 aslant = glm::normalize(vec3(camera[0]) - vec3(camera[1]));
    for (std::size_t i = 0; i < extents.size(); ++i) {
        const vec3 half = extents[i].half == vec3(0.0f) ? extents[i].size * aslant : extents[i].half;
        for (const float side : {1.0f, -1.0f}) {
            const auto edge = projection(center + side * half);
            if (edge && glm::distance(*edge, *at) > nearest * scale)
                handles.sizes.emplace_back(*edge, static_cast<int>(i));
        }
    }
    return handles;
}

std::optional<Handle> handle_under(vec2 pointer, const Handles& handles) {
    for (const auto& [at, extent] : handles.sizes)
        if (glm::distance(at, pointer) <= slack + square) return Handle{Verb::scale, extent};
    for (const Arrow& arrow : handles.arrows)
        if (distance_to_segment(pointer, arrow.from, arrow.to) <= slack)
            return Handle{Verb::move, arrow.axis};
    std::optional<Handle> found;
    float least = slack;
    for (int axis = 0; axis < 3; ++axis)
        if (const float d = distance_to(pointer, handles.rings[static_cast<std::size_t>(axis)]); d <= least) {
            least = d;
            found = Handle{Verb::turn, axis};
        }
    return found;
}

void draw(const Handles& handles, const std::optional<Handle>& held, float scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto width = [&](Verb verb, int axis) {
        return (held && held->verb == verb && held->axis == axis ? 5.0f : 2.0f) * scale;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const vec2 point : handles.rings[static_cast<std::size_t>(axis)])
            list.PathLineTo({point.x, point.y});
        list.PathStroke(palette::axes[static_cast<std::size_t>(axis)], ImDrawFlags_None,
                        width(Verb::turn, axis));
        const auto& ring = handles.rings[static_cast<std::size_t>(axis)];
        if (ring.empty()) continue;
        const vec2 middle = ring[ring.size() / 2];
        list.AddText({middle.x + 3.0f, middle.y + 1.0f}, palette::axes[static_cast<std::size_t>(axis)],
                     letters[static_cast<std::size_t>(axis)]);
    }
    for (const Arrow& arrow : handles.arrows) {
        const auto axis = static_cast<std::size_t>(arrow.axis);
        list.AddLine({arrow.from.x, arrow.from.y}, {arrow.to.x, arrow.to.y}, palette::axes[axis],
                     width(Verb::move, arrow.axis));
        list.AddText({arrow.to.x + 2.0f, arrow.to.y - 6.0f}, palette::axes[axis], letters[axis]);
    }
    constexpr ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
    for (const auto& [at, extent] : handles.sizes) {
        const float half =
            (held && held->verb == Verb::scale && held->axis == extent ? 1.4f : 1.0f) * square * scale;
        list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, white);
        list.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, black);
    }
}

void draw_words(const std::string& words, vec2 pointer, float scale) {
    if (words.empty()) return;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImVec2 at{pointer.x + 18.0f * scale, pointer.y + 14.0f * scale},
        size = ImGui::CalcTextSize(words.c_str());
    list.AddRectFilled({at.x - 4.0f, at.y - 2.0f}, {at.x + size.x + 4.0f, at.y + size.y + 2.0f},
                       IM_COL32(0, 0, 0, 190), 3.0f);
    list.AddText(at, IM_COL32(255, 255, 255, 255), words.c_str());
}

} // namespace sr::viewer
