#include "viewer/document/new_light.hpp"

#include "core/error.hpp"
#include "gltf/write/edited_copy.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::viewer {
namespace {

/// Two unit vectors across a direction, the first one level. u × v is the direction.
std::pair<vec3, vec3> across(vec3 direction) {
    const vec3 up = std::abs(direction.y) < 0.95f ? vec3(0.0f, 1.0f, 0.0f) : vec3(0.0f, 0.0f, 1.0f);
    const vec3 u = glm::normalize(glm::cross(up, direction));
    return {u, glm::cross(direction, u)};
}

} // namespace

scene::Light new_light(std::string_view kind, const NewLightPlace& place) {
    const vec3 path = place.target - place.at;
    const float distance = std::max(glm::length(path), 1e-6f);
    const vec3 direction = glm::length(path) > 0.0f ? glm::normalize(path) : vec3(0.0f, -1.0f, 0.0f);
    const auto [u, v] = across(direction);
    const float I = place.E * distance * distance; // [cd]
    const float half = 0.5f * place.size;
    const std::string name = fmt::format("new {}", kind);
    if (kind == "point") return scene::PointLight{name, place.at, vec3(I)};
    if (kind == "spot") {
        scene::SpotLight spot{name, place.at, direction, vec3(I)};
        spot.inner_angle = glm::radians(20.0f);
        spot.outer_angle = glm::radians(30.0f);
        return spot;
    }
    if (kind == "directional") return scene::DirectionalLight{name, direction, vec3(place.E)};
    if (kind == "rectangle") {
        const float height = 0.6f * half;
        return scene::RectangleLight{name, place.at, half * u, height * v, vec3(I / (4.0f * half * height))};
    }
    if (kind == "disk")
        return scene::DiskLight{name, place.at, half * u, half * v, vec3(I / (pi * half * half))};
    if (kind == "sphere") return scene::SphereLight{name, place.at, half, vec3(I / (pi * half * half))};
    require(kind == "tube", "the kind is one of new_light_kinds");
    const float radius = 0.04f * place.size;
    return scene::TubeLight{name, place.at, half * u, radius,
                            vec3(I / (4.0f * radius * half + pi * radius * radius))};
}

std::optional<scene::Light> duplicate_of(const scene::Light& light, float offset) {
    if (!gltf::is_addable(light)) return std::nullopt;
    scene::Light copy = transformed(light, glm::translate(mat4(1.0f), vec3(offset, 0.0f, 0.0f)));
    scene::set_name(copy, fmt::format("{} copy", name_of(light)));
    return copy;
}

} // namespace sr::viewer
