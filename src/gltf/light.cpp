#include "gltf/light.hpp"

#include "gltf/text.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sr::gltf {
namespace {

float range_of(const Document& document, const tinygltf::Light& light, const std::string& title) {
    if (light.range < 0.0)
        document.fail(fmt::format("{} has the range {}", title, light.range),
                      "give a positive range, or none");
    return light.range > 0.0 ? static_cast<float>(light.range) : std::numeric_limits<float>::infinity();
}

// KHR_lights_punctual: 0 <= inner < outer <= pi/2. A pi/2 that was rounded up when it was printed passes.
void check_cone(const Document& document, const tinygltf::SpotLight& spot, const std::string& title) {
    constexpr double right_angle = 1.5707963267948966 + 1e-6;
    if (spot.innerConeAngle >= 0.0 && spot.innerConeAngle < spot.outerConeAngle
        && spot.outerConeAngle <= right_angle)
        return;
    document.fail(fmt::format("{} has the cone angles {} (inner) and {} (outer)", title, spot.innerConeAngle,
                              spot.outerConeAngle),
                  "they must obey 0 <= inner < outer <= pi/2");
}

scene::Light punctual(const Document& document, const PlacedNode& placed, const tinygltf::Light& light,
                      const std::string& title) {
    const glm::dvec3 color =
        light.color.empty() ? glm::dvec3(1.0) : glm::dvec3(light.color[0], light.color[1], light.color[2]);
    const vec3 quantity = emitted_color(document, color, light.intensity, title);
    const vec3 position(placed.world_from_node[3]);
    if (light.type == "directional")
        return scene::DirectionalLight{light.name, direction_of(document, placed, title), quantity};
    if (light.type == "point")
        return scene::PointLight{light.name, position, quantity, range_of(document, light, title)};
    check_cone(document, light.spot, title);
    return scene::SpotLight{light.name,
                            position,
                            direction_of(document, placed, title),
                            quantity,
                            range_of(document, light, title),
                            static_cast<float>(light.spot.innerConeAngle),
                            static_cast<float>(light.spot.outerConeAngle)};
}

} // namespace

std::string light_title(std::string_view extension, int index, std::string_view name) {
    return fmt::format("light {} (/extensions/{}/lights/{})", in_quotes(name), extension, index);
}

vec3 direction_of(const Document& document, const PlacedNode& placed, const std::string& title) {
    const glm::dvec3 back(placed.world_from_node[2]);
    if (!(glm::length(back) > 0.0))
        document.fail(fmt::format("{} is scaled to nothing and so points nowhere", title),
                      "give its node a scale that is not zero");
    return vec3(-glm::normalize(back));
}

vec3 emitted_color(const Document& document, glm::dvec3 color, double quantity, const std::string& title) {
    if (!(quantity >= 0.0))
        document.fail(fmt::format("{} has the intensity {}", title, quantity), "give zero or more");
    if (!(color.x >= 0.0 && color.y >= 0.0 && color.z >= 0.0))
        document.fail(fmt::format("{} has the colour {} {} {}", title, color.x, color.y, color.z),
                      "give zero or more");
    const vec3 product(color * quantity);
    if (!std::isfinite(product.x) || !std::isfinite(product.y) || !std::isfinite(product.z))
        document.fail(fmt::format("{} is brighter than 32-bit floats can say", title), "lower its intensity");
    return product;
}

void append_lights(const Document& document, const PlacedNode& placed, std::vector<scene::Light>& lights,
                   Warnings& warnings) {
    const tinygltf::Node& node = document.model.nodes[static_cast<std::size_t>(placed.node)];
    if (const tinygltf::Value* reference = extension(node.extensions, "KHR_lights_punctual")) {
        const int index = whole_in(*reference, "light", 0);
        tinygltf::Light light = document.model.lights[static_cast<std::size_t>(index)];
        const std::string title = light_title("KHR_lights_punctual", index, light.name);
        if (light.name.empty()) light.name = node.name;
        lights.push_back(punctual(document, placed, light, title));
    }
    append_area_light(document, placed, lights, warnings);
}

} // namespace sr::gltf
