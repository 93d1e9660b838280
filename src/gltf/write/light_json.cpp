#include "gltf/write/light_json.hpp"

#include "core/error.hpp"
#include "scene/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <type_traits>

namespace sr::gltf {
namespace {

using nlohmann::ordered_json;

template<class L>
constexpr bool is_flat = requires(L light) {
    light.half_u;
};
template<class L>
constexpr bool is_tube = requires(L light) {
    light.half_axis;
};
template<class L>
constexpr bool is_punctual =
    std::is_same_v<
        L,
        scene::
            PointLight> || std::is_same_v<L, scene::SpotLight> || std::is_same_v<L, scene::DirectionalLight>;

ordered_json vector_json(glm::dvec3 v) { return {v.x, v.y, v.z}; }

glm::dmat4 frame(glm::dvec3 y, glm::dvec3 back, glm::dvec3 place) {
    glm::dmat4 m(1.0);
    m[0] = {glm::cross(y, back), 0.0};
    m[1] = {y, 0.0};
    m[2] = {back, 0.0};
    m[3] = {place, 1.0};
    return m;
}

/// A unit vector that is perpendicular to another one.
glm::dvec3 across(glm::dvec3 unit) {
    const glm::dvec3 axis = std::abs(unit.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    return glm::normalize(axis - glm::dot(axis, unit) * unit);
}

/// The frame of a flat light, which shines along -Z.
glm::dmat4 frame_of(glm::dvec3 center, vec3 half_u, vec3 half_v) {
    return frame(glm::normalize(glm::dvec3(half_v)),
                 -glm::normalize(glm::cross(glm::dvec3(half_u), glm::dvec3(half_v))), center);
}

/// The frame of a tube along X.
glm::dmat4 frame_along(glm::dvec3 center, vec3 half_axis) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(half_axis)), y = across(x);
    return frame(y, glm::cross(x, y), center);
}

/// The frame of a light that goes along -Z.
glm::dmat4 frame_towards(vec3 direction, glm::dvec3 place) {
    const glm::dvec3 back = -glm::normalize(glm::dvec3(direction));
    return frame(across(back), back, place);
}

/// States the place and the axes of a light at its node.
template<class L>
void place(const L& light, glm::dvec3 origin, ordered_json& node) {
    const auto in_file = [&](vec3 v) { return origin + glm::dvec3(v); };
    if constexpr (is_flat<L>)
        node["matrix"] = matrix_json(frame_of(in_file(light.center), light.half_u, light.half_v));
    else if constexpr (is_tube<L>)
        node["matrix"] = matrix_json(frame_along(in_file(light.center), light.half_axis));
    else if constexpr (std::is_same_v<L, scene::SphereLight>)
        node["translation"] = vector_json(in_file(light.center));
    else if constexpr (std::is_same_v<L, scene::PointLight>)
        node["translation"] = vector_json(in_file(light.position));
    else if constexpr (std::is_same_v<L, scene::SpotLight>)
        node["matrix"] = matrix_json(frame_towards(light.direction, in_file(light.position)));
    else if constexpr (std::is_same_v<L, scene::DirectionalLight>)
        node["matrix"] = matrix_json(frame_towards(light.direction, glm::dvec3(0.0)));
}

/// States the shape of a light, and what it has besides its sizes.
template<class L>
void state_shape(const L& light, glm::dvec3 origin, std::size_t size_count, ordered_json& steradian) {
    for (const auto& shape : L::shapes)
        if (shape.dimensions.size() == size_count) steradian["shape"] = shape.name;
    if constexpr (requires { light.corners; }) {
        steradian["corners"] = ordered_json::array();
        for (const vec3 corner : light.corners)
            steradian["corners"].push_back(vector_json(origin + glm::dvec3(corner)));
    }
    if constexpr (requires { light.is_two_sided; })
        if (light.is_two_sided) steradian["two_sided"] = true;
}

/// The object of KHR_lights_punctual for a light.
template<class L>
ordered_json punctual_json(const L& light) {
    ordered_json json{{"type", L::kind}, {"intensity", 1.0}};
    if constexpr (requires { light.range; })
        if (std::isfinite(light.range)) json["range"] = light.range;
    if constexpr (requires { light.outer_angle; })
        json["spot"] = {{"innerConeAngle", light.inner_angle}, {"outerConeAngle", light.outer_angle}};
    return json;
}

void add_punctual(ordered_json punctual, ordered_json& node, ordered_json& gltf) {
    ordered_json& lights = gltf["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back(std::move(punctual));
    node["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
    ordered_json& used = gltf["extensionsUsed"];
    if (used.is_null() || std::ranges::find(used, "KHR_lights_punctual") == used.end())
        used.push_back("KHR_lights_punctual");
}

} // namespace

ordered_json matrix_json(const glm::dmat4& matrix) {
    ordered_json json = ordered_json::array();
    for (int i = 0; i < 16; ++i) json.push_back(matrix[i / 4][i % 4]);
    return json;
}

void state_emission(ordered_json& steradian, const StatedEmission& emission) {
    if (!steradian.is_object()) steradian = ordered_json::object();
    for (const char* key : {"quantity", "color", "temperature", "spectrum"}) steradian.erase(key);
    steradian["quantity"] = {{"value", emission.value}, {"unit", emission.unit}};
    if (emission.value > 0.0)
        steradian["color"] = vector_json(scene::with_unit_luminance(glm::dvec3(emission.color)));
}

ordered_json light_node(const AddedLight& added, glm::dvec3 origin, ordered_json& gltf) {
    if (scene::needs_its_scene(added.light))
        throw Error(
            fmt::format("the copy '{}' of a {} light with a profile, a texture or a surface cannot be "
                        "stated",
                        scene::name_of(added.light), scene::variety_of(added.light)),
            "leave it out, or move the light of the file");
    const std::vector<scene::LightSize> sizes = scene::sizes_of(added.light);
    ordered_json node{{"name", scene::name_of(added.light)}};
    ordered_json steradian = ordered_json::object();
    std::visit(
        [&]<class L>(const L& light) {
            place(light, origin, node);
            if constexpr (requires { L::shapes; }) state_shape(light, origin, sizes.size(), steradian);
            if constexpr (is_punctual<L>) add_punctual(punctual_json(light), node, gltf);
            if constexpr (requires { light.is_visible; })
                if (!light.is_visible) steradian["visible"] = false;
            if constexpr (requires { light.angular_radius; })
                if (light.angular_radius > 0.0f) steradian["angular_diameter"] = 2.0f * light.angular_radius;
        },
        added.light);
    for (const scene::LightSize& size : sizes) steradian[std::string(size.key)] = size.size;
    state_emission(steradian, added.emission);
    node["extras"]["steradian"] = std::move(steradian);
    return node;
}

} // namespace sr::gltf
