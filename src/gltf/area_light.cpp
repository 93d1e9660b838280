// EXT_lights_area, as drafted in Khronos' glTF pull request 2525: flat emitters of constant luminance [nit].
#include "gltf/light.hpp"
#include "gltf/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::gltf {
namespace {

using glm::dvec3;
using tinygltf::Value;

std::string text_in(const Value& object, const std::string& key) {
    return object.Has(key) && object.Get(key).IsString() ? object.Get(key).Get<std::string>() : std::string();
}

dvec3 color_of(const Value& light) {
    if (!light.Has("color")) return dvec3(1.0);
    const Value& color = light.Get("color");
    return {color.Get(0).GetNumberAsDouble(), color.Get(1).GetNumberAsDouble(),
            color.Get(2).GetNumberAsDouble()};
}

// The draft scales an area light by one number: the largest of its node's world scale.
double largest_scale(const glm::dmat4& world) {
    return std::max(
        {glm::length(dvec3(world[0])), glm::length(dvec3(world[1])), glm::length(dvec3(world[2]))});
}

scene::RectangleLight rectangle(const Document& document, const PlacedNode& placed, const Value& light,
                                const std::string& title) {
    const double size = number_in(light, "size", 1.0);
    const double aspect = light.Has("rect") ? number_in(light.Get("rect"), "aspect", 1.0) : 1.0;
    const double scale = largest_scale(placed.world_from_node);
    const double half_width = 0.5 * scale * size * aspect;
    const double half_height = 0.5 * scale * size;
    const double area = 4.0 * half_width * half_height;
    if (!(size > 0.0 && aspect > 0.0) || !(area > 0.0) || !std::isfinite(static_cast<float>(area)))
        document.fail(
            fmt::format("{} has the size {}, the aspect {} and the scale {}", title, size, aspect, scale),
            "give positive ones");

    scene::RectangleLight result;
    result.L = emitted_color(document, color_of(light), number_in(light, "intensity", 1000.0), title);
    result.center = vec3(placed.world_from_node[3]);
    // Along the node's X and Y, made perpendicular to -Z; u turns around where the node mirrors, so that
    // cross(half_u, half_v) is where the light goes.
    const dvec3 normal(direction_of(document, placed, title));
    const dvec3 y(placed.world_from_node[1]);
    const dvec3 across = glm::cross(y, normal);
    if (!(glm::length(across) > 0.0))
        document.fail(fmt::format("{} is scaled to nothing", title),
                      "give its node a scale that is not zero");
    const dvec3 u = glm::normalize(across);
    result.half_u = vec3(half_width * u);
    result.half_v = vec3(half_height * glm::cross(normal, u));
    return result;
}

} // namespace

void append_area_light(const Document& document, const PlacedNode& placed, std::vector<scene::Light>& lights,
                       Warnings& warnings) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(placed.node)];
    const Value* reference = extension(node.extensions, "EXT_lights_area");
    if (!reference) return;
    const int index = whole_in(*reference, "light", 0);
    const Value& light = extension(document.model.extensions, "EXT_lights_area")->Get("lights").Get(index);
    const std::string name = text_in(light, "name");
    const std::string title = light_title("EXT_lights_area", index, name);
    std::string type = text_in(light, "type");
    if (type.empty()) type = text_in(light, "shape"); // its name in the draft's first versions
    if (type == "disk") {
        warnings.add(fmt::format("{} is a disk, which is not evaluated yet", title), "it is left out");
        return;
    }
    if (type != "rect")
        document.fail(fmt::format("{} has the type {}", title, in_quotes(type)), "give \"rect\" or \"disk\"");
    scene::RectangleLight result = rectangle(document, placed, light, title);
    result.name = name.empty() ? node.name : name;
    lights.emplace_back(std::move(result));
}

} // namespace sr::gltf
