#include "gltf/light.hpp"

#include "gltf/text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sr::gltf {
namespace {

using glm::dvec3;
using tinygltf::Value;

constexpr std::string_view point_takes =
    "state a point or a spot in lm or cd, or in W or W/sr; with a radius also in cd/m^2 or W/(m^2 sr)";
constexpr std::string_view sun_takes = "state a directional light in lx or W/m^2 (its beam is as wide as the "
                                       "scene, so that no flux or intensity is its "
                                       "own); with an angular_diameter also in cd/m^2 or W/(m^2 sr)";

/// What the extras of a light of KHR_lights_punctual, and over them those of its node, state.
class PunctualExtras {
public:
    PunctualExtras(const Document& document, const Value* node, const Value* light, const std::string& title)
        : document_(document), node_(node), light_(light), title_(title) {}

    Statement statement() const {
        return statement_of(document_, node_, title_).over(statement_of(document_, light_, title_));
    }

    /// A length or an angle; absent where neither states it.
    std::optional<double> number(const std::string& key) const {
        for (const Value* extras : {node_, light_})
            if (extras && extras->Has(key)) return number_in(*extras, key, 0.0);
        return std::nullopt;
    }

    void forbid(const std::string& key, std::string_view kind) const {
        if (number(key))
            document_.fail(fmt::format("{} has the {} of another kind of light", title_, key),
                           fmt::format("leave it out of a {} light", kind));
    }

    bool is_visible() const { return flag_in(node_, "visible", flag_in(light_, "visible", true)); }

private:
    const Document& document_;
    const Value* node_;
    const Value* light_;
    std::string title_;
};

float range_of(const Document& document, const tinygltf::Light& light, const std::string& title) {
    if (light.range < 0.0)
        document.fail(fmt::format("{} has the range {}", title, light.range),
                      "give a positive range, or none");
    return light.range > 0.0 ? static_cast<float>(light.range) : std::numeric_limits<float>::infinity();
}

struct Cone {
    double inner = 0.0;
    double outer = 0.0;
};

// KHR_lights_punctual: 0 <= inner < outer <= pi/2. Exporters write inner = outer for a hard edge (Blender's
// spot_blend 0); beyond that each angle is brought into its range, the outer one first.
Cone cone_of(const Document& document, const tinygltf::SpotLight& spot, const std::string& title,
             Warnings& warnings) {
    constexpr double right_angle = glm::half_pi<double>();
    constexpr double rounding = 1e-6; // of a pi/2 that was printed
    const double inner = spot.innerConeAngle, outer = spot.outerConeAngle;
    if (!(outer > 0.0))
        document.fail(fmt::format("{} has the outerConeAngle {}", title, outer),
                      "give one above 0, up to pi/2");
    const Cone cone{std::clamp(inner, 0.0, std::min(outer, right_angle)), std::min(outer, right_angle)};
    if (inner >= 0.0 && inner < outer && outer <= right_angle + rounding) return cone;
    const std::string angles =
        fmt::format("{} has the cone angles {} (inner) and {} (outer)", title, inner, outer);
    if (inner >= outer)
        warnings.add(angles, "inner < outer is required: its edge is hard");
    else
        warnings.add(angles,
                     fmt::format("0 <= inner < outer <= pi/2 is required: taken for {:.6g} and {:.6g}",
                                 cone.inner, cone.outer));
    return cone;
}

double largest_axis(const PlacedNode& placed) {
    const glm::dmat4& m = placed.world_from_node;
    return std::max({glm::length(dvec3(m[0])), glm::length(dvec3(m[1])), glm::length(dvec3(m[2]))});
}

/// What KHR_lights_punctual itself says of a light.
struct PunctualSource {
    const tinygltf::Light& from;
    dvec3 own{0.0};                // colour times intensity
    float range = 0.0f;            // [m]
    std::optional<Cone> cone;      // of a spot
    std::optional<LightFrame> aim; // of what has a direction
};

/// @throws Error if what the extension says makes no sense, or the light has no direction
PunctualSource source_of(const Document& document, const PlacedNode& placed, const tinygltf::Light& from,
                         const std::string& title, Warnings& warnings) {
    const dvec3 color = from.color.empty() ? dvec3(1.0) : dvec3(from.color[0], from.color[1], from.color[2]);
    PunctualSource source{
        from, emitted_color(document, color, from.intensity, title), range_of(document, from, title), {}, {}};
    if (from.type == "spot") source.cone = cone_of(document, from.spot, title, warnings);
    if (from.type != "point") source.aim = frame_of(document, placed, title);
    return source;
}

scene::Light directional(const Document& document, const PunctualSource& source, const PunctualExtras& extras,
                         const std::string& title) {
    extras.forbid("radius", "directional");
    scene::DirectionalLight light;
    light.direction = vec3(source.aim->front);
    if (const auto diameter = extras.number("angular_diameter")) {
        if (!(*diameter > 0.0 && *diameter < glm::pi<double>()))
            document.fail(fmt::format("{} has the angular_diameter {}", title, *diameter),
                          "give one between 0 and pi radians (the sun's is 0.0093)");
        light.angular_radius = static_cast<float>(0.5 * *diameter);
    }
    const Conversion conversion = [&](scene::Quantity quantity, double value) {
        return scene::sun_irradiance_from(quantity, value, light.angular_radius);
    };
    light.E = emitted(document, extras.statement(), source.own, conversion, title, sun_takes);
    return light;
}

/// What points and spots have in common: place, range, radius.
template<class Punctual>
Punctual placed_light(const Document& document, const PlacedNode& placed, const PunctualSource& source,
                      const PunctualExtras& extras, const std::string& title) {
    extras.forbid("angular_diameter", source.from.type);
    Punctual light;
    light.position = vec3(placed.world_from_node[3]);
    light.range = source.range;
    light.is_visible = extras.is_visible();
    LightFrame frame;
    frame.scale = largest_axis(placed);
    if (const auto radius = extras.number("radius"))
        light.radius = scaled_size(document, *radius, frame, "radius", title);
    return light;
}

scene::Light punctual(const Document& document, const PlacedNode& placed, const PunctualSource& source,
                      const PunctualExtras& extras, const std::string& title) {
    if (source.from.type == "directional") return directional(document, source, extras, title);
    if (source.from.type == "point") {
        auto light = placed_light<scene::PointLight>(document, placed, source, extras, title);
        const Conversion conversion = [&](scene::Quantity quantity, double value) {
            return scene::point_intensity_from(quantity, value, light.radius);
        };
        light.I = emitted(document, extras.statement(), source.own, conversion, title, point_takes);
        return light;
    }
    auto light = placed_light<scene::SpotLight>(document, placed, source, extras, title);
    light.direction = vec3(source.aim->front);
    light.inner_angle = static_cast<float>(source.cone->inner);
    light.outer_angle = static_cast<float>(source.cone->outer);
    const Conversion conversion = [&](scene::Quantity quantity, double value) {
        return scene::spot_intensity_from(quantity, value, light);
    };
    light.I = emitted(document, extras.statement(), source.own, conversion, title, point_takes);
    return light;
}

/// What extras without a shape can state of the lights that a node has by extensions; nothing if there are
/// none.
std::vector<std::string> properties_without_shape(const tinygltf::Node& node) {
    std::vector<std::string> known;
    const auto take = [&](const char* name, std::initializer_list<std::string> properties) {
        if (extension(node.extensions, name)) known.insert(known.end(), properties);
    };
    take("KHR_lights_punctual", {"radius", "angular_diameter"});
    take("EXT_lights_area", {"texture", "two_sided"});
    take("EXT_lights_ies", {"radius"});
    if (!known.empty())
        for (const char* shared : {"quantity", "color", "temperature", "spectrum", "visible"})
            known.emplace_back(shared);
    return known;
}

} // namespace

void LightTable::append_punctual(const PlacedNode& placed, Warnings& warnings) {
    const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(placed.node)];
    const Value* reference = extension(node.extensions, "KHR_lights_punctual");
    if (!reference) return;
    const int index = whole_in(*reference, "light", 0);
    if (document_.is_lost(fmt::format("/extensions/KHR_lights_punctual/lights/{}", index))) return;
    const tinygltf::Light& from = document_.model.lights[static_cast<std::size_t>(index)];
    const std::string title = light_title("KHR_lights_punctual", index, from.name);
    std::optional<PunctualSource> source;
    const bool is_read = warnings.attempt(
        without_lamp, [&] { source.emplace(source_of(document_, placed, from, title, warnings)); });
    if (!is_read) return;
    const Value* stated = steradian_in(node.extras);
    if (stated && stated->Has("shape")) stated = nullptr; // that is a light of its own
    const PunctualExtras extras(document_, stated, steradian_in(from.extras), title);
    scene::Light light = punctual(document_, placed, *source, extras, title);
    std::visit([&](auto& any) { any.name = from.name.empty() ? node.name : from.name; }, light);
    lights_.push_back(std::move(light));
}

void LightTable::append(const PlacedNode& placed, Warnings& warnings) {
    const tinygltf::Node& node = document_.model.nodes[static_cast<std::size_t>(placed.node)];
    const Value* stated = steradian_in(node.extras);
    // glTF's way to animate visibility (section 3.5.3, "Implementation Note").
    if (!(largest_axis(placed) > 0.0)) {
        if (!properties_without_shape(node).empty() || stated)
            warnings.add(fmt::format("/nodes/{} is scaled to 0", placed.node), "its lamp is off");
        return;
    }
    append_punctual(placed, warnings);
    append_area(placed, warnings);
    append_ies(placed, warnings);
    append_shape(placed, warnings);
    if (!stated || stated->Has("shape")) return;
    const std::vector<std::string> known = properties_without_shape(node);
    for (const std::string& key : stated->Keys())
        if (!known.empty() && std::find(known.begin(), known.end(), key) == known.end())
            document_.fail(
                fmt::format("/nodes/{}/extras/steradian states {}", placed.node, key),
                fmt::format("the light of this node has {}; leave it out", fmt::join(known, ", ")));
    if (known.empty())
        document_.fail(
            fmt::format("/nodes/{}/extras/steradian names no shape, and its node has no light", placed.node),
            "give it a \"shape\", or put it on the node of a light");
}

std::string light_title(std::string_view extension, int index, std::string_view name) {
    return fmt::format("light {} (/extensions/{}/lights/{})", in_quotes(name), extension, index);
}

LightFrame frame_of(const Document& document, const PlacedNode& placed, const std::string& title) {
    const dvec3 x(placed.world_from_node[0]), y(placed.world_from_node[1]), back(placed.world_from_node[2]);
    if (!(glm::length(back) > 0.0))
        document.fail(
            fmt::format("{} at /nodes/{} is scaled to nothing and so points nowhere", title, placed.node),
            "give its node a scale that is not zero");
    LightFrame frame;
    frame.position = dvec3(placed.world_from_node[3]);
    frame.front = -glm::normalize(back);
    const dvec3 across = glm::cross(y, frame.front);
    // A node that is flat across its light may still aim a spot; only what has a size needs u and v.
    frame.u = glm::length(across) > 0.0 ? glm::normalize(across) : dvec3(0.0);
    frame.v = glm::cross(frame.front, frame.u);
    frame.scale = std::max({glm::length(x), glm::length(y), glm::length(back)});
    return frame;
}

LightFrame sided_frame_of(const Document& document, const PlacedNode& placed, const std::string& title) {
    const LightFrame frame = frame_of(document, placed, title);
    const bool is_flat =
        !(glm::length(frame.u) > 0.0) || !(glm::length(dvec3(placed.world_from_node[0])) > 0.0);
    if (is_flat)
        document.fail(fmt::format("{} at /nodes/{} is scaled to nothing", title, placed.node),
                      "give its node a scale that is not zero");
    return frame;
}

float scaled_size(const Document& document, double size, const LightFrame& frame, std::string_view what,
                  const std::string& title) {
    const auto scaled = static_cast<float>(size * frame.scale);
    if (!(scaled > 0.0f) || !std::isfinite(scaled))
        document.fail(fmt::format("{} has the {} {}", title, what, size), "give a positive one");
    return scaled;
}

dvec3 emitted_color(const Document& document, dvec3 color, double quantity, const std::string& title) {
    if (!(quantity >= 0.0))
        document.fail(fmt::format("{} has the intensity {}", title, quantity), "give zero or more");
    if (!(color.x >= 0.0 && color.y >= 0.0 && color.z >= 0.0))
        document.fail(fmt::format("{} has the colour {} {} {}", title, color.x, color.y, color.z),
                      "give zero or more");
    return color * quantity;
}

std::string text_in(const Value& object, const std::string& key) {
    return object.Has(key) && object.Get(key).IsString() ? object.Get(key).Get<std::string>() : std::string();
}

bool flag_in(const Value* object, const std::string& key, bool fallback) {
    return object && object->Has(key) ? object->Get(key).Get<bool>() : fallback;
}

dvec3 color_in(const Value& object) {
    if (!object.Has("color")) return dvec3(1.0);
    const Value& color = object.Get("color");
    return {color.Get(0).GetNumberAsDouble(), color.Get(1).GetNumberAsDouble(),
            color.Get(2).GetNumberAsDouble()};
}

} // namespace sr::gltf
