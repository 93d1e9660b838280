#include "assignment/scene_changes.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

using Pointer = ordered_json::json_pointer;

/// Adds a change of the number at `pointer`, if the file has one there.
void add_number(std::vector<SceneChange>& changes, const ordered_json& gltf, const std::string& pointer,
                const std::string& what, double (*changed)(double), bool is_linear = false) {
    const Pointer place(pointer);
    if (!gltf.contains(place) || !gltf.at(place).is_number()) return;
    const double from = gltf.at(place);
    changes.push_back({what, pointer, "", gltf.at(place), changed(from), is_linear});
}

std::string name_of(const ordered_json& part, const char* kind, std::size_t i) {
    return fmt::format("{} '{}'", kind, part.value("name", std::to_string(i)));
}

double doubled(double value) { return 2.0 * value; }
double other_roughness(double value) { return value < 0.5 ? value + 0.3 : value - 0.3; }

void add_place(std::vector<SceneChange>& changes, const ordered_json& node, const std::string& pointer,
               const std::string& name) {
    if (node.contains("matrix")) return;
    const ordered_json from = node.value("translation", ordered_json());
    ordered_json to = from.is_null() ? ordered_json{0.0, 0.0, 0.0} : from;
    if (to.size() != 3 || !to[1].is_number()) return;
    to[1] = to[1].get<double>() + 0.3;
    changes.push_back({name + " 0.3 m higher (y)", pointer + "/translation", "", from, to, false});
}

void add_material(std::vector<SceneChange>& changes, const ordered_json& gltf, std::size_t i) {
    const std::string pointer = fmt::format("/materials/{}", i);
    const ordered_json& material = gltf["materials"][i];
    const std::string name = name_of(material, "material", i);
    add_number(changes, gltf, pointer + "/pbrMetallicRoughness/roughnessFactor",
               "another roughness of the " + name, other_roughness);
    add_number(changes, gltf, pointer + "/extras/steradian/exponent", "twice the exponent of the " + name,
               doubled);
    const std::string color = pointer + "/pbrMetallicRoughness/baseColorFactor";
    if (!gltf.contains(Pointer(color))) return;
    ordered_json to = gltf.at(Pointer(color));
    for (std::size_t c = 0; c < 3 && c < to.size(); ++c) {
        if (!to[c].is_number()) return;
        to[c] = 0.5 * to[c].get<double>();
    }
    changes.push_back({"half the base colour of the " + name, color, "", gltf.at(Pointer(color)), to, false});
}

} // namespace

std::vector<SceneChange> scene_changes(const ordered_json& gltf) {
    std::vector<SceneChange> changes;
    const Pointer lights("/extensions/KHR_lights_punctual/lights");
    if (gltf.contains(lights))
        for (std::size_t i = 0; i < gltf.at(lights).size(); ++i)
            add_number(changes, gltf, fmt::format("{}/{}/intensity", lights.to_string(), i),
                       "twice the intensity of the " + name_of(gltf.at(lights)[i], "light", i), doubled,
                       true);
    const ordered_json none = ordered_json::array();
    const ordered_json& nodes = gltf.contains("nodes") ? gltf["nodes"] : none;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const std::string pointer = fmt::format("/nodes/{}", i), name = name_of(nodes[i], "object", i);
        const bool is_light = nodes[i].contains(Pointer("/extensions/KHR_lights_punctual"))
                              || nodes[i].contains(Pointer("/extras/steradian/shape"));
        add_number(changes, gltf, pointer + "/extras/steradian/quantity/value",
                   "twice the luminance of the " + name, doubled, true);
        for (const char* size : {"width", "radius"})
            add_number(changes, gltf, fmt::format("{}/extras/steradian/{}", pointer, size),
                       fmt::format("twice the {} of the {}", size, name), doubled);
        if (is_light || nodes[i].contains("mesh")) add_place(changes, nodes[i], pointer, name);
    }
    const ordered_json& materials = gltf.contains("materials") ? gltf["materials"] : none;
    for (std::size_t i = 0; i < materials.size(); ++i) add_material(changes, gltf, i);
    return changes;
}

std::vector<SceneChange> parameter_changes(const Assignment& assignment, const Parameters& parameters) {
    std::vector<SceneChange> changes;
    for (const Parameter& parameter : assignment.parameters) {
        const double from = parameters.at(parameter.name);
        const double low = parameter.values.empty() ? parameter.low : parameter.values.front();
        const double high = parameter.values.empty() ? parameter.high : parameter.values.back();
        const double to = std::abs(from - low) > std::abs(high - from) ? low : high;
        changes.push_back(
            {fmt::format("{} [{}]: {:g} instead of {:g}", parameter.about, parameter.unit, to, from), "",
             parameter.name, from, to, false});
    }
    return changes;
}

} // namespace sr::assignment
