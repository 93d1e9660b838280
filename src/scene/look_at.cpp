#include "scene/look_at.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

namespace sr::scene {
namespace {

constexpr std::string_view grammar =
    "write eye=X,Y,Z;target=X,Y,Z and, if wanted, ;up=X,Y,Z;fov=DEGREES;near=METRES;far=METRES";

[[noreturn]] void refuse(std::string_view what) { throw Error(fmt::format("camera: {}", what), grammar); }

template<class Float>
Float number_in(std::string_view key, std::string_view text) {
    const std::string_view digits = trimmed(text);
    Float value = 0;
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (failure != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
        refuse(fmt::format("{} has '{}', which is no number", key, text));
    return value;
}

template<class Float>
glm::vec<3, Float> point_in(std::string_view key, std::string_view text) {
    glm::vec<3, Float> point(0);
    for (int i = 0; i < 3; ++i) {
        const auto comma = text.find(',');
        if ((comma == std::string_view::npos) != (i == 2)) refuse(fmt::format("{} takes three numbers", key));
        point[i] = number_in<Float>(key, text.substr(0, comma));
        text.remove_prefix(i == 2 ? text.size() : comma + 1);
    }
    return point;
}

/// Converts a point of the file's world to the scene's coordinates.
vec3 place_in(std::string_view key, std::string_view text, glm::dvec3 origin) {
    if (origin == glm::dvec3(0.0)) return point_in<float>(key, text);
    return vec3(point_in<double>(key, text) - origin);
}

void take(LookAt& view, std::string_view key, std::string_view value) {
    if (key == "eye")
        view.eye = place_in(key, value, view.origin);
    else if (key == "target")
        view.target = place_in(key, value, view.origin);
    else if (key == "up")
        view.up = point_in<float>(key, value);
    else if (key == "fov")
        view.yfov = glm::radians(number_in<float>(key, value));
    else if (key == "yfov")
        view.yfov = number_in<float>(key, value);
    else if (key == "ymag")
        view.ymag = number_in<float>(key, value);
    else if (key == "near")
        view.znear = number_in<float>(key, value);
    else if (key == "far")
        view.zfar = number_in<float>(key, value);
    else
        refuse(fmt::format("there is no '{}'", key));
}

void check(const LookAt& view) {
    const vec3 along = view.target - view.eye;
    const float distance = glm::length(along);
    if (!(distance > 0.0f)) refuse("eye and target are the same point");
    const vec3 across = glm::cross(along / distance, view.up);
    if (!(glm::length(across) > 1e-6f * glm::length(view.up))) refuse("up points along the view");
    if (!(view.yfov > 0.0f && view.yfov < pi)) refuse("the field of view is not between 0 and 180 degrees");
    if (view.ymag && !(*view.ymag > 0.0f)) refuse("ymag is not above 0");
    if (view.znear && !(*view.znear > 0.0f)) refuse("near is not above 0");
    if (view.zfar && !(*view.zfar > view.znear.value_or(0.0f))) refuse("far is not behind near");
}

std::string text_of(vec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

std::string text_of_place(vec3 v, glm::dvec3 origin) {
    if (origin == glm::dvec3(0.0)) return text_of(v);
    const glm::dvec3 world = origin + glm::dvec3(v);
    return fmt::format("{},{},{}", world.x, world.y, world.z);
}

} // namespace

DepthRange depth_range(const LookAt& view, const Bounds& bounds) {
    const vec3 forward = glm::normalize(view.target - view.eye);
    const float reach = glm::distance(view.target, view.eye);
    float nearest = 0.5f * reach, farthest = 2.0f * reach;
    if (!bounds.is_empty()) {
        const vec3 half = 0.5f * (bounds.max - bounds.min);
        const float middle = glm::dot(bounds.center() - view.eye, forward);
        const float around = glm::dot(half, glm::abs(forward));
        nearest = middle - around;
        farthest = std::max(middle + around, 1e-3f * reach);
    }
    // A little air, so that what lies on the bounds is not cut.
    const float air = 0.01f * std::max(std::abs(farthest), std::abs(nearest));
    if (view.ymag) return {view.znear.value_or(nearest - air), view.zfar.value_or(farthest + air)};
    // A float depth buffer resolves about far / near * 6e-8 of a distance.
    const float far = view.zfar.value_or(farthest + air);
    return {view.znear.value_or(std::max(nearest - air, 1e-4f * far)), far};
}

Camera camera_at(const LookAt& view, const Bounds& bounds, float aspect_ratio) {
    check(view);
    const vec3 back = glm::normalize(view.eye - view.target);
    const vec3 right = glm::normalize(glm::cross(view.up, back));
    const vec3 up = glm::cross(back, right);
    Camera camera;
    camera.name = text_of(view);
    camera.world_from_camera =
        mat4(vec4(right, 0.0f), vec4(up, 0.0f), vec4(back, 0.0f), vec4(view.eye, 1.0f));
    const DepthRange depth = depth_range(view, bounds);
    if (view.ymag)
        camera.projection = Orthographic{*view.ymag * aspect_ratio, *view.ymag, depth.near, depth.far};
    else
        camera.projection = Perspective{view.yfov, std::nullopt, depth.near, depth.far};
    return camera;
}

bool is_look_at(std::string_view text) {
    return text.find("eye=") != std::string_view::npos || text.find("target=") != std::string_view::npos;
}

LookAt parse_look_at(std::string_view text, glm::dvec3 origin) {
    LookAt view;
    view.origin = origin;
    bool has_eye = false, has_target = false;
    while (!trimmed(text).empty()) {
        const std::string_view part = trimmed(text.substr(0, text.find(';')));
        text.remove_prefix(std::min(text.size(), std::min(text.find(';'), text.size() - 1) + 1));
        const auto equals = part.find('=');
        if (equals == std::string_view::npos) refuse(fmt::format("'{}' says nothing", part));
        const std::string_view key = trimmed(part.substr(0, equals));
        take(view, key, part.substr(equals + 1));
        has_eye = has_eye || key == "eye";
        has_target = has_target || key == "target";
    }
    if (!has_eye || !has_target) refuse("eye and target are both needed");
    check(view);
    return view;
}

std::string text_of(const LookAt& view) {
    std::string text = fmt::format("eye={};target={}", text_of_place(view.eye, view.origin),
                                   text_of_place(view.target, view.origin));
    if (view.up != vec3(0.0f, 1.0f, 0.0f)) text += ";up=" + text_of(view.up);
    text += view.ymag ? fmt::format(";ymag={}", *view.ymag) : fmt::format(";yfov={}", view.yfov);
    if (view.znear) text += fmt::format(";near={}", *view.znear);
    if (view.zfar) text += fmt::format(";far={}", *view.zfar);
    return text;
}

} // namespace sr::scene
