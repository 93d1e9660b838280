#include "cli/light_description.hpp"

#include "scene/spectrum.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

ordered_json list(vec3 v) { return {v.x, v.y, v.z}; }

/// The smallest box around points.
ordered_json box(const scene::Bounds& bounds) {
    return {{"min", list(bounds.min)}, {"max", list(bounds.max)}};
}

class Describe {
public:
    explicit Describe(const scene::Scene& scene) : scene_(scene) {}

    ordered_json operator()(const scene::PointLight& l) const {
        ordered_json json = start(l);
        if (l.profile < 0) {
            json[quantity("I", scene::Quantity::intensity)] = list(l.I);
        } else {
            json["profile"] = scene_.profiles[static_cast<std::size_t>(l.profile)].name;
            json["factor"] = list(l.I);
        }
        return with_place(json, l);
    }
    ordered_json operator()(const scene::SpotLight& l) const {
        ordered_json json = start(l);
        json[quantity("I", scene::Quantity::intensity)] = list(l.I);
        json["inner angle [rad]"] = l.inner_angle;
        json["outer angle [rad]"] = l.outer_angle;
        json["direction"] = list(l.direction);
        return with_place(json, l);
    }
    ordered_json operator()(const scene::DirectionalLight& l) const {
        ordered_json json = start(l);
        json[quantity("E", scene::Quantity::irradiance)] = list(l.E);
        json["direction"] = list(l.direction);
        if (l.angular_radius > 0.0f) json["angular radius [rad]"] = l.angular_radius;
        return json;
    }
    /// A light of any other kind: a surface of one radiance.
    template<class Area>
    ordered_json operator()(const Area& l) const {
        ordered_json json = start(l);
        json[quantity("L", scene::Quantity::radiance)] = list(l.L);
        json["A [m^2]"] = l.area();
        if constexpr (requires { l.is_two_sided; }) json["two-sided"] = l.is_two_sided;
        if constexpr (requires { l.center + vec3(0.0f); }) json["center [m]"] = place(l.center);
        if constexpr (requires { l.normal(); }) json["normal"] = list(l.normal());
        if constexpr (requires { l.map; })
            if (l.map.is_present()) json["texture"] = l.map.texture;
        if constexpr (requires { l.half_u; })
            json["size [m]"] = {2.0f * glm::length(l.half_u), 2.0f * glm::length(l.half_v)};
        if constexpr (requires { l.half_axis; }) json["axis [m]"] = list(2.0f * l.half_axis);
        if constexpr (requires { l.radius; }) json["radius [m]"] = l.radius;
        if constexpr (requires { l.corners; })
            for (const vec3 corner : l.corners) json["corners [m]"].push_back(list(corner));
        if constexpr (requires { l.triangles; }) {
            json["triangles"] = l.triangles.size();
            json["bounds [m]"] = box(l.bounds());
        }
        if constexpr (requires { l.texture; })
            if (l.texture >= 0) json["texture"] = l.texture;
        return json;
    }

    ordered_json operator()(const scene::EnvironmentLight& l) const {
        ordered_json json = start(l);
        const auto radiance = quantity("L", scene::Quantity::radiance);
        if (l.map) {
            json["factor"] = list(l.L);
            json["mean " + radiance] = list(l.L * l.map->mean());
            json["texels"] = {l.map->width(), l.map->height()};
            json["rotation [rad]"] = l.rotation;
        } else {
            json[radiance] = list(l.L);
        }
        json["visible"] = l.is_visible;
        return json;
    }

    std::string quantity(const char* symbol, scene::Quantity kind) const {
        return fmt::format("{} [{}]", symbol, scene::name_of({kind, scene_.units}));
    }

private:
    template<class L>
    static ordered_json start(const L& light) {
        return {{"kind", light.kind}, {"name", light.name}};
    }

    template<class Punctual>
    ordered_json with_place(ordered_json json, const Punctual& l) const {
        json["position [m]"] = place(l.position);
        if (l.radius > 0.0f) json["radius [m]"] = l.radius;
        if (std::isfinite(l.range)) json["range [m]"] = l.range;
        return json;
    }

    /// A place in the file's world.
    ordered_json place(vec3 p) const {
        if (scene_.origin == glm::dvec3(0.0)) return list(p);
        const glm::dvec3 world = scene_.origin + glm::dvec3(p);
        return {world.x, world.y, world.z};
    }

    const scene::Scene& scene_;
};

} // namespace

ordered_json described(const scene::Light& light, const scene::Scene& scene) {
    const Describe describe(scene);
    ordered_json json = std::visit(describe, light);
    if (const auto flux = scene::flux_of(light, scene.profiles))
        json[describe.quantity("Phi", scene::Quantity::flux)] = scene::luminance(*flux);
    return json;
}

std::string text_of(const ordered_json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
    if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
    if (!value.is_structured()) return value.dump();
    std::string text;
    for (const auto& [key, entry] : value.items())
        text += (text.empty() ? "" : ", ") + (value.is_object() ? key + " " : "") + text_of(entry);
    return "(" + text + ")";
}

std::string line_of(const ordered_json& light) {
    std::string text =
        fmt::format("{} \"{}\"", light.at("kind").get<std::string>(), light.at("name").get<std::string>());
    const char* separator = ": ";
    for (const auto& [key, value] : light.items()) {
        if (key == "kind" || key == "name") continue;
        text += separator + key + " " + text_of(value);
        separator = ", ";
    }
    return text;
}

} // namespace sr::cli
