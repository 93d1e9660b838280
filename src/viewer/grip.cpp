#include "viewer/grip.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::viewer {
namespace {

constexpr std::array axis_names{"X", "Y", "Z"};
constexpr float smallest_factor = 0.01f; // a light keeps some size

/// From the point to the eye, unit.
vec3 towards_eye(vec3 point, const Projection& projection) {
    const auto at = projection(point);
    return at ? -projection.ray(*at).direction : glm::normalize(vec3(projection.camera.world_from_camera[2]));
}

/// Where the ray meets the plane through `center` across `normal`; absent where it does not.
std::optional<vec3> on_plane(vec3 center, vec3 normal, const Ray& ray) {
    const float along = glm::dot(ray.direction, normal);
    const float distance = glm::dot(center - ray.origin, normal) / along;
    if (!std::isfinite(distance) || distance <= 0.0f) return std::nullopt;
    return ray.origin + distance * ray.direction;
}

/// The number that was typed so far.
std::optional<float> number(const std::string& typed) {
    float value = 0.0f;
    const char* end = typed.data() + typed.size();
    const auto [stop, failure] = std::from_chars(typed.data(), end, value);
    if (failure != std::errc{} || stop != end) return std::nullopt;
    return value;
}

float snapped(float value, float step, bool snaps) { return snaps ? step * std::round(value / step) : value; }

vec3 moved_by(const Grip& grip, const Projection& projection, vec2 pointer, bool snaps) {
    if (const auto typed = number(grip.typed)) return *typed * axis_direction(grip.axis.value_or(0));
    vec3 by(0.0f);
    if (grip.axis) {
        by[*grip.axis] = along_axis(grip.center, *grip.axis, projection.ray(pointer))
                         - along_axis(grip.center, *grip.axis, projection.ray(grip.from));
    } else {
        const vec3 normal = towards_eye(grip.center, projection);
        const auto a = on_plane(grip.center, normal, projection.ray(grip.from));
        const auto b = on_plane(grip.center, normal, projection.ray(pointer));
        if (a && b) by = *b - *a;
    }
    for (int i = 0; i < 3; ++i) by[i] = snapped(by[i], 0.1f, snaps);
    return by;
}

/// The angle by which the pointer has gone around the axis, in the plane across it; where that plane is seen
/// from its side, as it would roll a wheel.
float angle_about(vec3 axis, const Grip& grip, const Projection& projection, vec2 pointer) {
    constexpr float least_facing = 0.2f;
    const vec3 view = towards_eye(grip.center, projection);
    const auto a = on_plane(grip.center, axis, projection.ray(grip.from));
    const auto b = on_plane(grip.center, axis, projection.ray(pointer));
    if (std::abs(glm::dot(axis, view)) > least_facing && a && b) {
        const vec3 from = *a - grip.center, to = *b - grip.center;
        return std::atan2(glm::dot(axis, glm::cross(from, to)), glm::dot(from, to));
    }
    const vec3 rolling = glm::cross(axis, view); // where the side near to the eye goes
    const auto metres = metres_of(grip.center, projection, ring_radius);
    const auto center = projection(grip.center);
    const auto rim = metres ? projection(grip.center + *metres * rolling) : std::nullopt;
    if (!center || !rim || *rim == *center) return 0.0f;
    return glm::dot(pointer - grip.from, glm::normalize(*rim - *center)) / ring_radius;
}

Pull turned(const Grip& grip, const Projection& projection, vec2 pointer, bool snaps) {
    const vec3 axis = grip.axis ? axis_direction(*grip.axis) : towards_eye(grip.center, projection);
    const auto typed = number(grip.typed);
    const float degrees =
        typed ? *typed : snapped(glm::degrees(angle_about(axis, grip, projection, pointer)), 15.0f, snaps);
    return {around(grip.center, glm::rotate(mat4(1.0f), glm::radians(degrees), axis)), 0.0f,
            fmt::format("turned by {:.1f} deg about {}", degrees,
                        grip.axis ? axis_names[static_cast<std::size_t>(*grip.axis)] : "the view")};
}

/// How much farther from the centre the pointer is than it was: on the screen, or along the extent that it
/// pulls.
float stretched(const Grip& grip, const Projection& projection, vec2 pointer) {
    const auto center = projection(grip.center);
    if (!center) return 1.0f;
    const vec3 half = grip.axis ? grip.extents[static_cast<std::size_t>(*grip.axis)].half : vec3(0.0f);
    if (!grip.is_free && half != vec3(0.0f)) {
        const vec3 along = glm::normalize(half);
        const float to = along_line(grip.center, along, projection.ray(pointer));
        const float from = along_line(grip.center, along, projection.ray(grip.from));
        return from == 0.0f ? 1.0f : to / from;
    }
    const float from = glm::distance(grip.from, *center);
    return glm::distance(pointer, *center) / std::max(from, 1.0f); // a pixel at least
}

Pull sized(const Grip& grip, const Projection& projection, vec2 pointer, bool snaps) {
    const auto typed = number(grip.typed);
    if (grip.axis) {
        const scene::LightSize& extent = grip.extents[static_cast<std::size_t>(*grip.axis)];
        const float pointed = snapped(extent.size * stretched(grip, projection, pointer), 0.1f, snaps);
        const float size = std::max(smallest_factor * extent.size, typed.value_or(pointed));
        return {mat4(1.0f), size, fmt::format("{} {:.4g} m", extent.key, size)};
    }
    const float factor = std::max(
        smallest_factor, typed ? *typed : snapped(stretched(grip, projection, pointer), 0.1f, snaps));
    return {around(grip.center, glm::scale(mat4(1.0f), vec3(factor))), 0.0f,
            fmt::format("scaled by {:.3g}", factor)};
}

} // namespace

void Grip::constrain_to(int other) {
    const bool is_none = verb == Verb::scale && static_cast<std::size_t>(other) >= extents.size();
    axis = is_none || axis == other ? std::nullopt : std::optional(other);
}

Pull pulled(const Grip& grip, const Projection& projection, vec2 pointer, bool snaps) {
    if (grip.verb == Verb::turn) return turned(grip, projection, pointer, snaps);
    if (grip.verb == Verb::scale) return sized(grip, projection, pointer, snaps);
    const vec3 by = moved_by(grip, projection, pointer, snaps);
    return {glm::translate(mat4(1.0f), by), 0.0f,
            fmt::format("moved by {:.3f} {:.3f} {:.3f} m", by.x, by.y, by.z)};
}

bool type_digit(std::string& typed, int key) {
    constexpr std::size_t most = 12;
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
    if (typed.size() < most) typed += digit;
    return true;
}

} // namespace sr::viewer
