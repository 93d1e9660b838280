#include "gltf/read/lights.hpp"

#include "gltf/read/node_light.hpp"
#include "gltf/uri.hpp"
#include "gltf/warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace sr::gltf {
namespace {

using glm::dvec3;

/// The consequence of a lost lamp, as warnings state it.
constexpr std::string_view without_lamp = "until then that lamp is off";

/// The properties of extras.steradian that all lights have.
constexpr std::array common_keys{"quantity", "color", "temperature", "spectrum", "visible"};

/// Returns a node's extras.steradian for the lights that extensions put on the node. Null: there is none, or
/// it names a shape, which is a light of its own.
const json* extras_of_extension(const json& node) {
    const json* authored = steradian_in(node);
    return authored && authored->contains("shape") ? nullptr : authored;
}

template<class L>
Conversion conversion_for(const L& light) {
    return
        [&](scene::Quantity quantity, double value) { return scene::quantity_from(light, quantity, value); };
}

// KHR_lights_punctual.

constexpr std::string_view point_takes =
    "state a point or a spot in lm or cd, or in W or W/sr; with a radius also in cd/m^2 or W/(m^2 sr)";
constexpr std::string_view sun_takes = "state a directional light in lx or W/m^2 (its beam is as wide as the "
                                       "scene, so that no flux or intensity is its "
                                       "own); with an angular_diameter also in cd/m^2 or W/(m^2 sr)";

/// The extras of a light of KHR_lights_punctual. Those of its node override its own.
class PunctualExtras {
public:
    PunctualExtras(const Document& document, const json* node, const json* light, const std::string& title)
        : document_(document), node_(node), light_(light), title_(title) {}

    EmissionSpec emission() const {
        return parse_emission(document_, node_, title_).over(parse_emission(document_, light_, title_));
    }

    /// A length or an angle; absent where neither states it.
    std::optional<double> number(const std::string& key) const {
        for (const json* extras : {node_, light_})
            if (extras && extras->contains(key)) return number_in(*extras, key, 0.0);
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
    const json* node_;
    const json* light_;
    std::string title_;
};

float parse_range(const Document& document, const json& light, const std::string& title) {
    const double range = number_in(light, "range", 0.0);
    if (range < 0.0)
        document.fail(fmt::format("{} has the range {}", title, range), "give a positive range, or none");
    return range > 0.0 ? static_cast<float>(range) : std::numeric_limits<float>::infinity();
}

struct Cone {
    double inner = 0.0;
    double outer = 0.0;
};

// KHR_lights_punctual: 0 <= inner < outer <= pi/2. Exporters write inner = outer for a hard edge (Blender's
// spot_blend 0); beyond that each angle is brought into its range, the outer one first.
Cone parse_cone(const Document& document, const json& spot, const std::string& title, Warnings& warnings) {
    constexpr double right_angle = glm::half_pi<double>();
    constexpr double rounding = 1e-6; // of a pi/2 that was printed
    const double inner = number_in(spot, "innerConeAngle", 0.0);
    const double outer = number_in(spot, "outerConeAngle", glm::quarter_pi<double>());
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

/// The properties of a light that KHR_lights_punctual itself states.
struct PunctualSource {
    std::string type;
    dvec3 own{0.0};                // colour times intensity
    float range = 0.0f;            // [m]
    std::optional<Cone> cone;      // of a spot
    std::optional<LightFrame> aim; // of what has a direction
};

/// @throws Error if what the extension says makes no sense, or the light has no direction
PunctualSource parse_punctual(const Document& document, const NodeTransform& transform, const json& from,
                              const std::string& title, Warnings& warnings) {
    const dvec3 color = three_in(from, "color", dvec3(1.0));
    PunctualSource source{text_in(from, "type"),
                          emitted_color(document, color, number_in(from, "intensity", 1.0), title),
                          parse_range(document, from, title),
                          {},
                          {}};
    if (source.type == "spot") source.cone = parse_cone(document, from.at("spot"), title, warnings);
    if (source.type != "point") source.aim = build_frame(document, transform, title);
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
    light.E = emitted(document, extras.emission(), source.own, conversion_for(light), title, sun_takes);
    if (light.angular_radius < 1e-6f)
        light.angular_radius = 0.0f; // as good as none, and its sine's square a float
    return light;
}

/// Returns a point or a spot with the properties that both have: place, range, visibility, radius.
template<class Punctual>
Punctual placed_light(const Document& document, const NodeTransform& transform, const PunctualSource& source,
                      const PunctualExtras& extras, const std::string& title) {
    extras.forbid("angular_diameter", source.type);
    Punctual light;
    light.position = vec3(transform.world_from_node[3]);
    light.range = source.range;
    light.is_visible = extras.is_visible();
    LightFrame frame;
    frame.scale = max_scale(transform);
    if (const auto radius = extras.number("radius"))
        light.radius = scaled_size(document, *radius, frame, "radius", title);
    return light;
}

scene::Light punctual(const Document& document, const NodeTransform& transform, const PunctualSource& source,
                      const PunctualExtras& extras, const std::string& title) {
    if (source.type == "directional") return directional(document, source, extras, title);
    if (source.type == "point") {
        auto light = placed_light<scene::PointLight>(document, transform, source, extras, title);
        light.I = emitted(document, extras.emission(), source.own, conversion_for(light), title, point_takes);
        return light;
    }
    auto light = placed_light<scene::SpotLight>(document, transform, source, extras, title);
    light.direction = vec3(source.aim->front);
    light.inner_angle = static_cast<float>(source.cone->inner);
    light.outer_angle = static_cast<float>(source.cone->outer);
    light.I = emitted(document, extras.emission(), source.own, conversion_for(light), title, point_takes);
    return light;
}

/// Returns the properties that extras without a shape can state of the lights that a node has by extensions;
/// empty if it has no such light.
std::vector<std::string> properties_without_shape(const json& node) {
    std::vector<std::string> known;
    const auto take = [&](const char* name, std::initializer_list<std::string> properties) {
        if (extension(node, name)) known.insert(known.end(), properties);
    };
    take("KHR_lights_punctual", {"radius", "angular_diameter"});
    take("EXT_lights_area", {"texture", "two_sided"});
    take("EXT_lights_ies", {"radius"});
    if (!known.empty()) known.insert(known.end(), common_keys.begin(), common_keys.end());
    return known;
}

// Lights with an area.

constexpr std::string_view area_takes =
    "state an area light in lm, cd or cd/m^2, or in W, W/sr or W/(m^2 sr): lx says what arrives elsewhere";

/// Sets L of an area light, and what else extras.steradian says of one. @throws Error
template<class Area>
void set_emission(const Document& document, Area& light, const json* authored, dvec3 own,
                  const std::string& title) {
    light.is_visible = flag_in(authored, "visible", true);
    if constexpr (requires { light.is_two_sided; })
        light.is_two_sided = flag_in(authored, "two_sided", false);
    light.L = emitted(document, parse_emission(document, authored, title), own, conversion_for(light), title,
                      area_takes);
}

// EXT_lights_area, as drafted in Khronos' glTF pull request 2525: flat emitters of constant luminance [nit].

/// Half the edges of a rectangle, or the semi-axes of a disk, `size` high and `aspect` times as wide.
template<class Flat>
Flat flat_light(const Document& document, const LightFrame& frame, double size, double aspect,
                const std::string& title) {
    const double half_width = 0.5 * frame.scale * size * aspect;
    const double half_height = 0.5 * frame.scale * size;
    const double area = 4.0 * half_width * half_height;
    if (!(size > 0.0 && aspect > 0.0) || !(area > 0.0) || !std::isfinite(static_cast<float>(area)))
        document.fail(fmt::format("{} has the size {}, the aspect {} and the scale {}", title, size, aspect,
                                  frame.scale),
                      "give positive ones");
    Flat result;
    result.center = vec3(frame.position);
    result.half_u = vec3(half_width * frame.u);
    result.half_v = vec3(half_height * frame.v);
    return result;
}

/// The properties of a light that EXT_lights_area itself states: place and size, and colour times intensity.
using AreaSource = std::pair<std::variant<scene::DiskLight, scene::RectangleLight>, dvec3>;

AreaSource parse_area(const Document& document, const NodeTransform& transform, const json& light,
                      const std::string& title) {
    std::string type = text_in(light, "type");
    if (type.empty()) type = text_in(light, "shape"); // its name in the draft's first versions
    if (type != "rect" && type != "disk")
        document.fail(fmt::format("{} has the type {}", title, in_quotes(type)), "give \"rect\" or \"disk\"");
    const LightFrame frame = build_sided_frame(document, transform, title);
    const double size = number_in(light, "size", 1.0);
    const dvec3 own = emitted_color(document, three_in(light, "color", dvec3(1.0)),
                                    number_in(light, "intensity", 1000.0), title);
    if (type == "disk") return {flat_light<scene::DiskLight>(document, frame, size, 1.0, title), own};
    const double aspect = light.contains("rect") ? number_in(light.at("rect"), "aspect", 1.0) : 1.0;
    return {flat_light<scene::RectangleLight>(document, frame, size, aspect, title), own};
}

// Shapes of extras.steradian, which no extension of glTF has. A light stands at its node and goes along -Z.

/// Returns the keys that a shape requires besides the common ones: its sizes, and the corners of a polygon.
template<class L>
std::vector<std::string> keys_of(const scene::NamedShape<L>& shape) {
    std::vector<std::string> keys;
    for (const auto& size : shape.dimensions) keys.emplace_back(size.key);
    if constexpr (requires(L light) { light.corners; }) keys.emplace_back("corners");
    return keys;
}

/// @throws Error if the object lacks what the shape needs, or has what the shape has not
template<class L>
void check_properties(const Document& document, const json& authored, const scene::NamedShape<L>& shape,
                      const std::string& title) {
    const std::vector<std::string> needs = keys_of(shape);
    for (const std::string& key : needs)
        if (!authored.contains(key))
            document.fail(fmt::format("{} is a {} without {}", title, shape.name, key), "give it one");
    for (const auto& [key, value] : authored.items()) {
        bool is_known = key == "shape" || std::ranges::find(common_keys, key) != common_keys.end()
                        || std::ranges::find(needs, key) != needs.end();
        if constexpr (requires(L light) { light.map; }) is_known |= key == "texture";
        if constexpr (requires(L light) { light.is_two_sided; }) is_known |= key == "two_sided";
        if (!is_known)
            document.fail(
                fmt::format("{} is a {} with {}", title, shape.name, key),
                fmt::format("a {} has {}: leave {} out", shape.name, fmt::join(needs, " and "), key));
    }
    if (!authored.contains("quantity"))
        document.fail(fmt::format("{} states no quantity", title),
                      R"(give one, as in "quantity": {"value": 800, "unit": "lm"})");
}

/// A light of that shape at the frame, all but what it emits.
template<class L>
L shaped(const Document& document, const json& authored, const scene::NamedShape<L>& shape,
         const NodeTransform& transform, const LightFrame& frame, const std::string& title) {
    L light;
    if constexpr (requires { light.center = vec3(0.0f); }) light.center = vec3(frame.position);
    if constexpr (requires { light.half_u; }) {
        light.half_u = vec3(frame.u);
        light.half_v = vec3(frame.v);
    }
    if constexpr (requires { light.half_axis; }) light.half_axis = vec3(frame.u);
    if constexpr (requires { light.radius; }) light.radius = 1.0f;
    for (const auto& size : shape.dimensions) {
        const std::string key(size.key);
        const float scaled = scaled_size(document, number_in(authored, key, 0.0), frame, key, title);
        size.scale(light, scaled / size.per_member);
    }
    if constexpr (requires { light.corners; })
        light.corners = parse_corners(document, authored.at("corners"), transform.world_from_node, title);
    return light;
}

// EXT_lights_ies (Khronos, vendor extension, complete): a point light whose intensities an IES file gives.
// Photometric zero is the node's -Z and the horizontal angle turns from its X towards its Y, as the
// extension's "Coordinate System Mapping" has it.

constexpr std::string_view ies_takes =
    "an IES light has the intensities of its file: state its flux in lm or W";

// The extension clamps colours to 0..1.
dvec3 parse_tint(const Document& document, const json& instance, const std::string& title) {
    const dvec3 color = glm::min(three_in(instance, "color", dvec3(1.0)), dvec3(1.0));
    const double multiplier = number_in(instance, "multiplier", 1.0);
    return emitted_color(document, color, multiplier, title);
}

} // namespace

void LightTable::append_punctual(const NodeTransform& transform, Warnings& warnings) {
    const auto found = find_light(document_, transform, "KHR_lights_punctual");
    if (!found) return;
    const std::string& title = found->title;
    std::optional<PunctualSource> source;
    const bool is_read = warnings.attempt(without_lamp, [&] {
        source.emplace(parse_punctual(document_, transform, found->light, title, warnings));
    });
    if (!is_read) return;
    const PunctualExtras extras(document_, extras_of_extension(found->node), steradian_in(found->light),
                                title);
    scene::Light light = punctual(document_, transform, *source, extras, title);
    scene::set_name(light, found->name());
    lights_.push_back(std::move(light));
}

void LightTable::append(const NodeTransform& transform, Warnings& warnings) {
    const json& node = *transform.source;
    if (!node.contains("extensions") && !node.contains("extras")) return;
    const json* authored = steradian_in(node);
    // glTF's way to animate visibility (section 3.5.3, "Implementation Note").
    if (!(max_scale(transform) > 0.0)) {
        if (!properties_without_shape(node).empty() || authored)
            warnings.add(fmt::format("/nodes/{} is scaled to 0", transform.node), "its lamp is off");
        return;
    }
    append_punctual(transform, warnings);
    append_area(transform, warnings);
    append_ies(transform, warnings);
    append_shape(transform, warnings);
    if (!authored || authored->contains("shape")) return;
    const std::vector<std::string> known = properties_without_shape(node);
    for (const auto& [key, value] : authored->items())
        if (!known.empty() && std::find(known.begin(), known.end(), key) == known.end())
            document_.fail(
                fmt::format("/nodes/{}/extras/steradian states {}", transform.node, key),
                fmt::format("the light of this node has {}; leave it out", fmt::join(known, ", ")));
    if (known.empty())
        document_.fail(fmt::format("/nodes/{}/extras/steradian names no shape, and its node has no light",
                                   transform.node),
                       "give it a \"shape\", or put it on the node of a light");
}

void LightTable::append_area(const NodeTransform& transform, Warnings& warnings) {
    const auto found = find_light(document_, transform, "EXT_lights_area");
    if (!found) return;
    const std::string& title = found->title;
    std::optional<AreaSource> source;
    warnings.attempt(without_lamp, [&] { source = parse_area(document_, transform, found->light, title); });
    if (!source) return;

    const json* authored = extras_of_extension(found->node);
    std::visit(
        [&](auto& result) {
            result.name = found->name();
            result.map = map_of(authored, transform);
            set_emission(document_, result, authored, source->second, title);
            lights_.emplace_back(std::move(result));
        },
        source->first);
}

const std::pair<int, scene::IesLuminaire>& LightTable::luminaire(int index, const std::string& title) {
    if (const auto known = luminaires_.find(index); known != luminaires_.end()) return known->second;
    const std::string pointer = fmt::format("/extensions/EXT_lights_ies/lights/{}", index);
    const json& light = document_.root.at(json::json_pointer(pointer));
    const std::string uri = text_in(light, "uri");
    const int view = integer_in(light, "bufferView", -1);
    if (uri.empty() == (view < 0))
        document_.fail(fmt::format("{} has not one of uri and bufferView", title),
                       "name where its IES file is");
    const bool is_embedded = uri.empty() || is_data_uri(uri);
    const std::string name =
        is_embedded ? fmt::format("{}({})", document_.name, pointer) : (document_.folder / uri).string();
    std::vector<std::uint8_t> file;
    if (uri.empty()) {
        const Bytes bytes = document_.view(view, pointer);
        file.assign(bytes.begin(), bytes.end());
    } else {
        file = read_uri(uri, document_.folder, {document_.name, pointer + "/uri"});
    }
    const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
    const auto entry = luminaires_.emplace(
        index, std::pair(static_cast<int>(profiles_.size()), scene::read_ies(text, name)));
    profiles_.push_back(entry.first->second.second.profile);
    return entry.first->second;
}

void LightTable::append_ies(const NodeTransform& transform, Warnings& warnings) {
    const auto found = find_light(document_, transform, "EXT_lights_ies");
    if (!found) return;
    const int index = found->index;
    const std::string& title = found->title;
    const json* authored = extras_of_extension(found->node);

    LightFrame frame;
    scene::PointLight light;
    dvec3 tint(0.0);
    const bool is_read = warnings.attempt(without_lamp, [&] {
        light.profile = luminaire(index, title).first;
        frame = build_frame(document_, transform, title);
        light.world_from_profile = world_from_profile(document_, transform, frame, title);
        tint = parse_tint(document_, found->reference, title);
    });
    if (!is_read) return;
    const scene::IesLuminaire& luminaire = luminaires_.at(index).second;
    light.name = found->name();
    light.position = vec3(frame.position);
    light.is_visible = flag_in(authored, "visible", true);
    if (authored && authored->contains("radius"))
        light.radius = scaled_size(document_, number_in(*authored, "radius", 0.0), frame, "radius", title);

    const double from_nadir = std::acos(glm::clamp(-frame.front.y, -1.0, 1.0));
    const double tilt = luminaire.tilt ? scene::tilt_factor(*luminaire.tilt, from_nadir) : 1.0;
    const EmissionSpec emission = parse_emission(document_, authored, title);
    const double efficacy = emission.color ? emission.color->efficacy : scene::lumens_per_watt;
    const double in_scene =
        scene::converted(tilt, scene::UnitSystem::photometric, unit_system_of(document_), efficacy);
    const double flux = scene::flux_of(luminaire.profile);
    const Conversion conversion = [&](scene::Quantity quantity, double value) {
        const bool is_determined = quantity == scene::Quantity::flux && flux > 0.0;
        return is_determined ? std::optional(value / flux) : std::nullopt;
    };
    light.I = emitted(document_, emission, in_scene * tint, conversion, title, ies_takes);
    lights_.emplace_back(std::move(light));
}

scene::EmissionMap LightTable::map_of(const json* authored, const NodeTransform& transform) {
    scene::EmissionMap map;
    if (authored && authored->contains("texture"))
        map.texture = textures_.texture(integer_in(*authored, "texture", 0), scene::ColorSpace::srgb);
    if (glm::determinant(glm::dmat3(transform.world_from_node)) < 0.0)
        map.along_u = -map.along_u; // the frame's u does not follow the node's X there
    return map;
}

void LightTable::append_shape(const NodeTransform& transform, Warnings& warnings) {
    const json& node = *transform.source;
    const json* authored = steradian_in(node);
    if (!authored || !authored->contains("shape")) return;
    const std::string title = fmt::format("light {} (/nodes/{}/extras/steradian)",
                                          in_quotes(text_in(node, "name")), transform.node);
    const std::string name = text_in(*authored, "shape");
    const auto append = [&](const auto& shape) {
        check_properties(document_, *authored, shape, title);
        std::optional<LightFrame> frame;
        warnings.attempt(without_lamp, [&] { frame = build_sided_frame(document_, transform, title); });
        if (!frame) return;
        auto light = shaped(document_, *authored, shape, transform, *frame, title);
        light.name = text_in(node, "name");
        if constexpr (requires { light.map; }) light.map = map_of(authored, transform);
        set_emission(document_, light, authored, dvec3(1.0), title);
        lights_.emplace_back(std::move(light));
    };
    scene::for_each_light_kind([&]<class L>(std::type_identity<L>) {
        if constexpr (requires { L::shapes; })
            for (const auto& shape : L::shapes)
                if (shape.name == name) append(shape);
    });
}

} // namespace sr::gltf
