#include "file_changes.hpp"

#include <algorithm>
#include <cmath>

namespace sr::testing {
namespace {

constexpr double pi_ = 3.14159265358979323846;

json* found(json& object, const std::string& pointer) {
    const json::json_pointer path(pointer);
    return object.contains(path) ? &object[path] : nullptr;
}

void multiply(json& object, const char* key, double factor) {
    if (object.contains(key)) object[key] = factor * object[key].get<double>();
}

double number(const json& object, const char* key, double otherwise) {
    return object.contains(key) ? object[key].get<double>() : otherwise;
}

/// Of linear Rec. 709 colours (ITU-R BT.709-6, item 3.2).
double luminance(const json& rgb) {
    return 0.2126 * rgb[0].get<double>() + 0.7152 * rgb[1].get<double>() + 0.0722 * rgb[2].get<double>();
}

/// A quantity in every unit that can state it.
struct Statement {
    const char* photometric;
    const char* radiometric;
    double value; // in the photometric unit
};

constexpr double lumens_per_watt = 683.0; // of light without a spectrum

Statement intensity(double value) { return {"cd", "W/sr", value}; }
Statement flux(double value) { return {"lm", "W", value}; }
Statement radiance(double value) { return {"cd/m^2", "W/(m^2 sr)", value}; }

void state(json& object, const std::vector<Statement>& choices, Random& random) {
    const Statement& s = choices[static_cast<std::size_t>(random.below(static_cast<int>(choices.size())))];
    const bool is_radiometric = random.has_chance(0.5);
    object["extras"]["steradian"]["quantity"] = {
        {"value", is_radiometric ? s.value / lumens_per_watt : s.value},
        {"unit", is_radiometric ? s.radiometric : s.photometric}};
}

/// Areas of an emitter by which its radiance makes its flux (Φ = π L emitting) and intensity (I = L facing).
struct Areas {
    double emitting; // both sides, where both emit [m²]
    double facing;   // as seen along the axis [m²]
};

std::vector<Statement> of_radiance(double L, const Areas& areas) {
    return {radiance(L), flux(pi_ * L * areas.emitting), intensity(L * areas.facing)};
}

/// `k`: the scale of the node.
Areas areas_of(const json& shape, double k) {
    const std::string kind = shape["shape"];
    const auto length = [&](const char* key) { return k * shape[key].get<double>(); };
    if (kind == "sphere") {
        const double r = length("radius");
        return {4.0 * pi_ * r * r, pi_ * r * r};
    }
    if (kind == "tube") { // a cylinder between two half spheres
        const double r = length("radius"), l = length("length");
        return {2.0 * pi_ * r * l + 4.0 * pi_ * r * r, 2.0 * r * l + pi_ * r * r};
    }
    double area = 0.0;
    if (kind == "polygon") {
        const json& corners = shape["corners"];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const json &a = corners[i], &b = corners[(i + 1) % corners.size()];
            area += 0.5 * k * k
                    * (a[0].get<double>() * b[1].get<double>() - a[1].get<double>() * b[0].get<double>());
        }
        area = std::abs(area);
    } else if (kind == "disk") {
        area = pi_ * length("radius") * length("radius");
    } else {
        area = length("width") * length("height") * (kind == "ellipse" ? pi_ / 4.0 : 1.0);
    }
    return {shape.value("two_sided", false) ? 2.0 * area : area, area};
}

double radiance_of(const json& quantity, const Areas& areas) {
    const double value = quantity["value"];
    if (quantity["unit"] == "lm") return value / (pi_ * areas.emitting);
    return quantity["unit"] == "cd" ? value / areas.facing : value;
}

/// ∫ of the cone's falloff over all directions: 1 within the inner cone, and a squared ramp in cosθ to the
/// outer one, whose mean is a third.
double solid_angle(const json& spot) {
    const double inner = std::cos(number(spot, "innerConeAngle", 0.0));
    const double outer = std::cos(number(spot, "outerConeAngle", pi_ / 4.0));
    return 2.0 * pi_ * ((1.0 - inner) + (inner - outer) / 3.0);
}

void restate_punctual(json& light, const json& node, Random& random) {
    const double value = light["intensity"].get<double>() * luminance(light["color"]);
    const json extras = node.value(json::json_pointer("/extras/steradian"), json::object());
    std::vector<Statement> choices{intensity(value)};
    if (light["type"] == "point") choices.push_back(flux(4.0 * pi_ * value));
    if (light["type"] == "spot") choices.push_back(flux(solid_angle(light["spot"]) * value));
    if (light["type"] == "directional") {
        choices = {{"lx", "W/m^2", value}};
        if (const double sine = std::sin(0.5 * number(extras, "angular_diameter", 0.0)); sine > 0.0)
            choices.push_back(radiance(value / (pi_ * sine * sine)));
    }
    if (const double r = number(extras, "radius", 0.0) * node["scale"][0].get<double>(); r > 0.0)
        choices.push_back(radiance(value / (pi_ * r * r)));
    state(light, choices, random);
}

void restate_area(json& node, const json& light, Random& random) {
    const double k = node["scale"][0];
    const double height = k * light["size"].get<double>();
    const double area = height * height * light["rect"]["aspect"].get<double>();
    state(node, of_radiance(light["intensity"].get<double>() * luminance(light["color"]), {area, area}),
          random);
}

void restate_material(json& material, Random& random) {
    const json* strength = found(material, "/extensions/KHR_materials_emissive_strength/emissiveStrength");
    if (strength)
        state(material, {radiance(strength->get<double>() * luminance(material["emissiveFactor"]))}, random);
}

/// Puts element i of the list at place to[i].
void reorder(json& list, const std::vector<int>& to) {
    const json before = list;
    for (std::size_t i = 0; i < to.size(); ++i) list[static_cast<std::size_t>(to[i])] = before[i];
}

void renumber_nodes(json& indices, const std::vector<int>& to, Random& random) {
    for (json& index : indices) index = to[index.get<std::size_t>()];
    reorder(indices, random.order(indices.size()));
}

} // namespace

MadeGltf under_root(MadeGltf made, const Similarity& similarity) {
    const double s = similarity.scale;
    json& root = made.root;
    if (json* lights = found(root, "/extensions/KHR_lights_punctual/lights"))
        for (json& light : *lights) {
            if (light["type"] != "directional") multiply(light, "intensity", s * s);
            multiply(light, "range", s);
        }
    for (json& node : root["nodes"]) {
        if (json* profile = found(node, "/extensions/EXT_lights_ies"))
            multiply(*profile, "multiplier", s * s);
        json* quantity = found(node, "/extras/steradian/quantity");
        if (quantity && (*quantity)["unit"] != "cd/m^2") multiply(*quantity, "value", s * s);
    }
    for (const char* kind : {"perspective", "orthographic"})
        if (json* lens = found(root["cameras"][0], std::string("/") + kind))
            for (const char* length : {"znear", "zfar", "xmag", "ymag"}) multiply(*lens, length, s);
    json matrix = json::array();
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) matrix.push_back(s * similarity.turn[column][row]);
        matrix.push_back(0.0);
    }
    for (int row = 0; row < 3; ++row) matrix.push_back(similarity.translation[row]);
    matrix.push_back(1.0);
    root["nodes"].push_back({{"matrix", matrix}, {"children", root["scenes"][0]["nodes"]}});
    root["scenes"][0]["nodes"] = {root["nodes"].size() - 1};
    return made;
}

MadeGltf in_other_units(MadeGltf made, Random& random) {
    json& root = made.root;
    for (json& node : root["nodes"]) {
        if (const json* reference = found(node, "/extensions/KHR_lights_punctual/light"))
            restate_punctual(
                root["extensions"]["KHR_lights_punctual"]["lights"][reference->get<std::size_t>()], node,
                random);
        if (const json* reference = found(node, "/extensions/EXT_lights_area/light"))
            restate_area(node, root["extensions"]["EXT_lights_area"]["lights"][reference->get<std::size_t>()],
                         random);
        json* shape = found(node, "/extras/steradian");
        if (!shape || !shape->contains("shape")) continue;
        const Areas areas = areas_of(*shape, node["scale"][0]);
        state(node, of_radiance(radiance_of((*shape)["quantity"], areas), areas), random);
    }
    for (json& material : root["materials"]) restate_material(material, random);
    return made;
}

MadeGltf in_other_order(MadeGltf made, Random& random) {
    json& root = made.root;
    const std::vector<int> nodes = random.order(root["nodes"].size());
    std::vector<int> lights;
    if (json* list = found(root, "/extensions/KHR_lights_punctual/lights")) {
        lights = random.order(list->size());
        reorder(*list, lights);
    }
    for (json& node : root["nodes"]) {
        if (node.contains("children")) renumber_nodes(node["children"], nodes, random);
        if (json* light = found(node, "/extensions/KHR_lights_punctual/light"))
            *light = lights[light->get<std::size_t>()];
    }
    renumber_nodes(root["scenes"][0]["nodes"], nodes, random);
    reorder(root["nodes"], nodes);
    return made;
}

} // namespace sr::testing
