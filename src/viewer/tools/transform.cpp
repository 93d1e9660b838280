#include "viewer/tools/transform.hpp"

#include "viewer/palette.hpp"
#include "viewer/panels/lights.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <imgui.h>
#include <utility>

namespace sr::viewer {
namespace {

constexpr float min_factor = 0.01f; // of a size

/// Unit vector from a point to the camera.
vec3 towards_eye(vec3 point, const Projection& projection) {
    const auto at = projection(point);
    return at ? -projection.ray(*at).direction : glm::normalize(vec3(projection.camera.world_from_camera[2]));
}

/// Intersection of a ray with the plane through `center` with this normal; absent if there is none.
std::optional<vec3> on_plane(vec3 center, vec3 normal, const PickRay& ray) {
    const float along = glm::dot(ray.direction, normal);
    const float distance = glm::dot(center - ray.origin, normal) / along;
    if (!std::isfinite(distance) || distance <= 0.0f) return std::nullopt;
    return ray.origin + distance * ray.direction;
}

/// The number that is typed so far.
std::optional<float> typed_number(const std::string& typed) {
    float value = 0.0f;
    const char* end = typed.data() + typed.size();
    const auto [stop, failure] = std::from_chars(typed.data(), end, value);
    if (failure != std::errc{} || stop != end) return std::nullopt;
    return value;
}

float snapped(float value, float step, bool snaps) { return snaps ? step * std::round(value / step) : value; }

vec3 moved_by(const TransformDrag& drag, const Projection& projection, vec2 pointer, bool snaps) {
    if (const auto typed = typed_number(drag.typed)) return *typed * axis_direction(drag.axis.value_or(0));
    vec3 by(0.0f);
    if (drag.axis) {
        by[*drag.axis] = along_axis(drag.center, *drag.axis, projection.ray(pointer))
                         - along_axis(drag.center, *drag.axis, projection.ray(drag.from));
    } else {
        const vec3 normal = towards_eye(drag.center, projection);
        const auto a = on_plane(drag.center, normal, projection.ray(drag.from));
        const auto b = on_plane(drag.center, normal, projection.ray(pointer));
        if (a && b) by = *b - *a;
    }
    for (int i = 0; i < 3; ++i) by[i] = snapped(by[i], 0.1f, snaps);
    return by;
}

/// Angle of the pointer's motion around the axis, in the plane across it. Where that plane is seen edge-on,
/// the pointer rolls a wheel.
float angle_about(vec3 axis, const TransformDrag& drag, const Projection& projection, vec2 pointer) {
    constexpr float min_facing = 0.2f;
    const vec3 view = towards_eye(drag.center, projection);
    const auto a = on_plane(drag.center, axis, projection.ray(drag.from));
    const auto b = on_plane(drag.center, axis, projection.ray(pointer));
    if (std::abs(glm::dot(axis, view)) > min_facing && a && b) {
        const vec3 from = *a - drag.center, to = *b - drag.center;
        return std::atan2(glm::dot(axis, glm::cross(from, to)), glm::dot(from, to));
    }
    const vec3 rolling = glm::cross(axis, view); // motion of the side that faces the camera
    const auto metres = metres_of(drag.center, projection, ring_radius);
    const auto center = projection(drag.center);
    const auto rim = metres ? projection(drag.center + *metres * rolling) : std::nullopt;
    if (!center || !rim || *rim == *center) return 0.0f;
    return glm::dot(pointer - drag.from, glm::normalize(*rim - *center)) / ring_radius;
}

TransformDelta turned(const TransformDrag& drag, const Projection& projection, vec2 pointer, bool snaps) {
    const vec3 axis = drag.axis ? axis_direction(*drag.axis) : towards_eye(drag.center, projection);
    const auto typed = typed_number(drag.typed);
    const float degrees =
        typed ? *typed : snapped(glm::degrees(angle_about(axis, drag, projection, pointer)), 15.0f, snaps);
    return {around(drag.center, glm::rotate(mat4(1.0f), glm::radians(degrees), axis)), 0.0f,
            fmt::format("turned by {:.1f} deg about {}", degrees,
                        drag.axis ? axis_names[static_cast<std::size_t>(*drag.axis)] : "the view")};
}

/// Ratio of the pointer's distances to the centre, now and at the beginning: on the screen, or along the
/// extent that is dragged.
float stretched(const TransformDrag& drag, const Projection& projection, vec2 pointer) {
    const auto center = projection(drag.center);
    if (!center) return 1.0f;
    const vec3 half = drag.axis ? drag.extents[static_cast<std::size_t>(*drag.axis)].half : vec3(0.0f);
    if (!drag.is_free && half != vec3(0.0f)) {
        const vec3 along = glm::normalize(half);
        const float to = along_line(drag.center, along, projection.ray(pointer));
        const float from = along_line(drag.center, along, projection.ray(drag.from));
        return from == 0.0f ? 1.0f : to / from;
    }
    const float from = glm::distance(drag.from, *center);
    return glm::distance(pointer, *center) / std::max(from, 1.0f); // at least a pixel
}

TransformDelta sized(const TransformDrag& drag, const Projection& projection, vec2 pointer, bool snaps) {
    const auto typed = typed_number(drag.typed);
    if (drag.axis) {
        const scene::LightSize& extent = drag.extents[static_cast<std::size_t>(*drag.axis)];
        const float pointed = snapped(extent.size * stretched(drag, projection, pointer), 0.1f, snaps);
        const float size = std::max(min_factor * extent.size, typed.value_or(pointed));
        return {mat4(1.0f), size, fmt::format("{} {:.4g} m", extent.key, size)};
    }
    const float factor =
        std::max(min_factor, typed ? *typed : snapped(stretched(drag, projection, pointer), 0.1f, snaps));
    return {around(drag.center, glm::scale(mat4(1.0f), vec3(factor))), 0.0f,
            fmt::format("scaled by {:.3g}", factor)};
}

constexpr float pick_slack = 6.0f;           // [pixels]
constexpr float arrow_length = 70.0f;        // [pixels]
constexpr float square = 5.0f;               // half its side [pixels]
constexpr float min_square_distance = 14.0f; // [pixels] from the centre, which stays visible
constexpr int ring_steps = 64;

std::vector<vec2> ring(vec3 center, int axis, const Projection& projection, float radius) {
    const vec3 eye(projection.camera.world_from_camera[3]);
    const bool is_flat = std::holds_alternative<scene::Orthographic>(projection.camera.projection);
    const vec3 view = is_flat ? vec3(projection.camera.world_from_camera[2]) : eye - center;
    vec3 u(0.0f), v(0.0f);
    u[(axis + 1) % 3] = v[(axis + 2) % 3] = 1.0f;
    // The half that faces the camera, from one of its ends to the other.
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
    float nearest = 1e30f;
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        nearest = std::min(nearest, distance_to_segment(p, line[i], line[i + 1]));
    return nearest;
}

void draw_handles(const Handles& handles, const TransformDrag* drag, float scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto width = [&](TransformMode mode, int axis) {
        return (drag && drag->mode == mode && drag->axis == axis ? 5.0f : 2.0f) * scale;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const vec2 point : handles.rings[static_cast<std::size_t>(axis)])
            list.PathLineTo({point.x, point.y});
        list.PathStroke(palette::axes[static_cast<std::size_t>(axis)], ImDrawFlags_None,
                        width(TransformMode::turn, axis));
        const auto& ring = handles.rings[static_cast<std::size_t>(axis)];
        if (ring.empty()) continue;
        const vec2 middle = ring[ring.size() / 2];
        list.AddText({middle.x + 3.0f, middle.y + 1.0f}, palette::axes[static_cast<std::size_t>(axis)],
                     axis_names[static_cast<std::size_t>(axis)]);
    }
    for (const Arrow& arrow : handles.arrows) {
        const auto axis = static_cast<std::size_t>(arrow.axis);
        list.AddLine({arrow.from.x, arrow.from.y}, {arrow.to.x, arrow.to.y}, palette::axes[axis],
                     width(TransformMode::move, arrow.axis));
        list.AddText({arrow.to.x + 2.0f, arrow.to.y - 6.0f}, palette::axes[axis], axis_names[axis]);
    }
    constexpr ImU32 white = IM_COL32(255, 255, 255, 255), black = IM_COL32(0, 0, 0, 255);
    for (const auto& [at, extent] : handles.sizes) {
        const float half = (drag && drag->mode == TransformMode::scale && drag->axis == extent ? 1.4f : 1.0f)
                           * square * scale;
        list.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, white);
        list.AddRect({at.x - half, at.y - half}, {at.x + half, at.y + half}, black);
    }
}

void draw_label(const std::string& text, vec2 pointer, float scale) {
    if (text.empty()) return;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImVec2 at{pointer.x + 18.0f * scale, pointer.y + 14.0f * scale},
        size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled({at.x - 4.0f, at.y - 2.0f}, {at.x + size.x + 4.0f, at.y + size.y + 2.0f},
                       IM_COL32(0, 0, 0, 190), 3.0f);
    list.AddText(at, IM_COL32(255, 255, 255, 255), text.c_str());
}

} // namespace

void TransformDrag::constrain_to(int other) {
    const bool is_none = mode == TransformMode::scale && static_cast<std::size_t>(other) >= extents.size();
    axis = is_none || axis == other ? std::nullopt : std::optional(other);
}

TransformDelta evaluate(const TransformDrag& drag, const Projection& projection, vec2 pointer, bool snaps) {
    if (drag.mode == TransformMode::turn) return turned(drag, projection, pointer, snaps);
    if (drag.mode == TransformMode::scale) return sized(drag, projection, pointer, snaps);
    const vec3 by = moved_by(drag, projection, pointer, snaps);
    return {glm::translate(mat4(1.0f), by), 0.0f,
            fmt::format("moved by {:.3f} {:.3f} {:.3f} m", by.x, by.y, by.z)};
}

Handles handles_of(const std::vector<scene::LightSize>& extents, vec3 center, bool has_place,
                   const Projection& projection, float scale) {
    Handles handles;
    const auto at = projection(center);
    const auto radius = metres_of(center, projection, ring_radius * scale);
    if (!at || !radius) return handles;
    for (int axis = 0; axis < 3; ++axis)
        handles.rings[static_cast<std::size_t>(axis)] = ring(center, axis, projection, *radius);
    if (!has_place) return handles;
    handles.middle = *at;
    if (const auto arrows = arrows_at(center, projection, arrow_length * scale))
        handles.arrows.assign(arrows->begin(), arrows->end());
    const mat4& camera = projection.camera.world_from_camera;
    const vec3 diagonal = glm::normalize(vec3(camera[0]) - vec3(camera[1]));
    for (std::size_t i = 0; i < extents.size(); ++i) {
        const vec3 half = extents[i].half == vec3(0.0f) ? extents[i].size * diagonal : extents[i].half;
        for (const float side : {1.0f, -1.0f}) {
            const auto edge = projection(center + side * half);
            if (edge && glm::distance(*edge, *at) > min_square_distance * scale)
                handles.sizes.emplace_back(*edge, static_cast<int>(i));
        }
    }
    return handles;
}

std::optional<Handle> handle_under(vec2 pointer, const Handles& handles) {
    for (const auto& [at, extent] : handles.sizes)
        if (glm::distance(at, pointer) <= pick_slack + square) return Handle{TransformMode::scale, extent};
    if (handles.middle && glm::distance(*handles.middle, pointer) <= pick_slack)
        return Handle{TransformMode::move, -1};
    for (const Arrow& arrow : handles.arrows)
        if (distance_to_segment(pointer, arrow.from, arrow.to) <= pick_slack)
            return Handle{TransformMode::move, arrow.axis};
    std::optional<Handle> found;
    float nearest = pick_slack;
    for (int axis = 0; axis < 3; ++axis)
        if (const float d = distance_to(pointer, handles.rings[static_cast<std::size_t>(axis)]);
            d <= nearest) {
            nearest = d;
            found = Handle{TransformMode::turn, axis};
        }
    return found;
}

bool type_digit(std::string& typed, int key) {
    constexpr std::size_t max_digits = 12;
    if (key == GLFW_KEY_BACKSPACE) {
        if (!typed.empty()) typed.pop_back();
        return true;
    }
    char digit = 0;
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) digit = static_cast<char>('0' + key - GLFW_KEY_0);
    if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) digit = static_cast<char>('0' + key - GLFW_KEY_KP_0);
    if (key == GLFW_KEY_PERIOD || key == GLFW_KEY_KP_DECIMAL) digit = '.';
    if (key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_SUBTRACT) digit = '-';
    if (digit == 0) return false;
    if (typed.size() < max_digits) typed += digit;
    return true;
}

/// The fixed point of turning and scaling. Lights without a place turn around the pivot of the view.
vec3 Transform::center() const {
    return center_of(ws_.scene->lights(), ws_.selected).value_or(ws_.camera->view().pivot);
}

std::optional<Handles> Transform::handles() const {
    const LightEditor& lights = ws_.scene->lights();
    const auto can_move = [&](std::size_t entry) { return lights.can_move(entry); };
    if (std::ranges::none_of(ws_.selected.entries(), can_move)) return std::nullopt;
    const bool has_place = center_of(lights, ws_.selected).has_value();
    return handles_of(extents(), center(), has_place, ws_.projection(), ws_.ui.scale());
}

/// The extents that can be dragged: those of a single light.
std::vector<scene::LightSize> Transform::extents() const {
    if (ws_.selected.count() != 1) return {};
    return scene::sizes_of(ws_.scene->lights().lights_of(*ws_.selected).front());
}

Changes Transform::update(double /*seconds*/) {
    frame_before_ = std::exchange(frame_, std::chrono::steady_clock::now());
    return {};
}

std::optional<Changes> Transform::handle(const Event& event) {
    if (!ws_.selected) drag_.reset();
    ws_.is_time_held = drag_.has_value();
    if (const auto* key = std::get_if<KeyEvent>(&event)) return handle_key(*key);
    if (const auto command = command_in(event)) return execute(*command);
    return handle_pointer(event);
}

std::optional<Changes> Transform::handle_pointer(const Event& event) {
    if (const auto* motion = std::get_if<MotionEvent>(&event)) {
        pointer_ = motion->to;
        return drag_ ? std::optional(drag_to(pointer_)) : std::nullopt;
    }
    const auto* button = std::get_if<ButtonEvent>(&event);
    if (!button)
        return drag_ && std::holds_alternative<ScrollEvent>(event) ? std::optional(Changes()) : std::nullopt;
    if (drag_) {
        const bool ends = drag_->is_free == button->is_down;
        return ends ? end(button->button == Button::left) : Changes();
    }
    if (button->button != Button::left || !button->is_down || button->modifiers != no_modifier)
        return std::nullopt;
    const auto all = handles();
    const auto handle = all ? handle_under(pointer_, *all) : std::nullopt;
    if (!handle) return std::nullopt;
    begin(handle->mode, handle->axis < 0 ? std::nullopt : std::optional(handle->axis), false);
    return Change::redraw;
}

/// During a drag all keys belong to it.
std::optional<Changes> Transform::handle_key(const KeyEvent& event) {
    if (!drag_) return handle_refused(event);
    if (event.key == GLFW_KEY_ESCAPE) return end(false);
    if (event.key == GLFW_KEY_ENTER || event.key == GLFW_KEY_KP_ENTER) return end(true);
    const int axis = event.key - GLFW_KEY_X;
    if (axis >= 0 && axis < 3)
        drag_->constrain_to(axis);
    else if (!type_digit(drag_->typed, event.key))
        return Changes();
    return drag_to(pointer_);
}

/// An axis, a number and Enter soon after a refused transform are no commands. Any other key ends this.
std::optional<Changes> Transform::handle_refused(const KeyEvent& event) {
    constexpr auto soon = std::chrono::seconds(2);
    if (frame_before_ - refused_ > soon) return std::nullopt; // however long a frame took
    const auto now = std::chrono::steady_clock::now();
    std::string ignored;
    const bool is_operand =
        event.modifiers == no_modifier
        && ((event.key >= GLFW_KEY_X && event.key <= GLFW_KEY_Z) || type_digit(ignored, event.key));
    const bool is_end =
        event.key == GLFW_KEY_ESCAPE || event.key == GLFW_KEY_ENTER || event.key == GLFW_KEY_KP_ENTER;
    refused_ = is_operand ? now : now - 2 * soon;
    return is_operand || is_end ? std::optional(Changes()) : std::nullopt;
}

std::optional<Changes> Transform::execute(Command command) {
    std::optional<TransformMode> mode;
    if (command == Command::move_light) mode = TransformMode::move;
    if (command == Command::turn_light) mode = TransformMode::turn;
    if (command == Command::scale_light) mode = TransformMode::scale;
    if (!mode) return std::nullopt;
    const std::string refused = refusal(*mode);
    if (refused.empty())
        begin(*mode, std::nullopt, true);
    else
        refused_ = std::chrono::steady_clock::now();
    ws_.messages.notify(
        refused.empty() ? "X, Y, Z: constrain to an axis. Type a number. Click, Enter: confirm. Esc: cancel."
                        : refused);
    return Change::redraw;
}

/// The reason why none of the selected lights can be transformed so; empty if one can.
std::string Transform::refusal(TransformMode mode) const {
    const LightEditor& lights = ws_.scene->lights();
    if (!ws_.selected) return select_first;
    const auto can_move = [&](std::size_t entry) { return lights.can_move(entry); };
    if (std::ranges::none_of(ws_.selected.entries(), can_move)) return "Emissive surfaces cannot be moved.";
    if (mode != TransformMode::turn && !center_of(lights, ws_.selected))
        return "A directional light can only be turned (R).";
    if (ws_.selected.count() == 1 && mode == TransformMode::scale
        && !is_scalable(lights.lights_of(*ws_.selected).front()))
        return "A light without a size cannot be scaled. Give it a radius in its file.";
    return {};
}

void Transform::begin(TransformMode mode, std::optional<int> axis, bool is_free) {
    TransformDrag drag;
    drag.mode = mode;
    drag.is_free = is_free;
    drag.center = center();
    drag.from = pointer_;
    drag.extents = extents();
    if (axis) drag.constrain_to(*axis);
    drag_ = std::move(drag);
    ws_.is_time_held = true;
    ws_.scene->lights().begin_step(ws_.selected.count());
}

/// A light without a size casts no shadow.
Changes Transform::changes() const {
    const LightEditor& lights = ws_.scene->lights();
    const bool casts = std::ranges::any_of(ws_.selected.entries(), [&](std::size_t entry) {
        return is_scalable(lights.lights_of(entry).front());
    });
    return casts ? Change::lights | Change::shadows : Changes(Change::lights);
}

Changes Transform::drag_to(vec2 pointer) {
    LightEditor& lights = ws_.scene->lights();
    const bool snaps = ws_.input.is_down(GLFW_KEY_LEFT_CONTROL) || ws_.input.is_down(GLFW_KEY_RIGHT_CONTROL);
    const TransformDelta delta = evaluate(*drag_, ws_.projection(), pointer, snaps);
    lights.restart_step();
    if (delta.size > 0.0f)
        lights.set_size(*ws_.selected, static_cast<std::size_t>(*drag_->axis), delta.size);
    else
        for (const std::size_t entry : ws_.selected.entries())
            if (drag_->mode == TransformMode::turn || center_of(lights, entry))
                lights.transform(entry, delta.transform); // nowhere is a parallel light moved to
    drag_->description = delta.description;
    return changes();
}

Changes Transform::end(bool keeps) {
    ws_.is_time_held = false;
    const std::string description = std::exchange(drag_, std::nullopt)->description;
    if (description.empty()) return Change::redraw;
    if (keeps) {
        ws_.messages.notify(description);
        return Change::redraw;
    }
    ws_.scene->lights().cancel_step();
    ws_.messages.notify("Change discarded.");
    return changes();
}

Changes Transform::draw(const Overlay& overlay) {
    const auto all = handles();
    if (!all) return {};
    draw_handles(*all, drag_ ? &*drag_ : nullptr, overlay.scale);
    if (drag_) draw_label(drag_->description, pointer_, overlay.scale);
    return {};
}

std::unique_ptr<Tool> make_transform(Workspace& workspace) { return std::make_unique<Transform>(workspace); }

} // namespace sr::viewer
