#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/version.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "gl/context.hpp"
#include "gltf/asset.hpp"
#include "gltf/extensions.hpp"
#include "render/gpu/features.hpp"
#include "scene/material.hpp"
#include "scene/prepare.hpp"
#include "scene/scene.hpp"
#include "scene/spectrum.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

ordered_json list(vec3 v) { return {v.x, v.y, v.z}; }

/// The smallest box around points.
ordered_json box(const scene::Bounds& bounds) {
    return {{"min", list(bounds.min)}, {"max", list(bounds.max)}};
}

class LightDescription {
public:
    explicit LightDescription(const scene::Scene& scene) : scene_(scene) {}

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

/// A light's kind, name, quantity as RGB, area, flux Φ (its luminance; a texture counts as white) and where
/// and how large it is. Each key names its unit, that of a radiometric scene if the scene is one.
ordered_json describe(const scene::Light& light, const scene::Scene& scene) {
    const LightDescription describe(scene);
    ordered_json json = std::visit(describe, light);
    if (const auto flux = scene::flux_of(light, scene.profiles))
        json[describe.quantity("Phi", scene::Quantity::flux)] = scene::luminance(*flux);
    return json;
}

/// A value as people read it: texts without quotes, numbers with six digits, lists in brackets.
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

/// A described light in one line: "rectangle "panel": L [cd/m^2] (200, 200, 100), A [m^2] 2, …".
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

ordered_json backends_json() {
    ordered_json list = ordered_json::array();
    for (const gl::BackendReport& report : gl::report_backends()) {
        ordered_json entry{{"name", report.name}, {"works", report.info.has_value()}};
        if (report.info) {
            entry["kind"] = report.info->backend;
            entry["GL_RENDERER"] = report.info->renderer;
            entry["GL_VERSION"] = report.info->version;
            entry["GLSL_VERSION"] = report.info->shading_language;
        } else {
            entry["failure"] = report.failure;
        }
        list.push_back(std::move(entry));
    }
    return list;
}

void print_backends(const ordered_json& backends) {
    print_data("{}\n\nOpenGL backends, in the order in which --backend auto tries them:\n",
               name_and_version());
    for (const auto& entry : backends) {
        if (entry["works"])
            print_data("  {:<8} {}\n           OpenGL {}, GLSL {} ({})\n", entry["name"].get<std::string>(),
                       entry["GL_RENDERER"].get<std::string>(), entry["GL_VERSION"].get<std::string>(),
                       entry["GLSL_VERSION"].get<std::string>(), entry["kind"].get<std::string>());
        else
            print_data("  {:<8} does not work here: {}\n", entry["name"].get<std::string>(),
                       entry["failure"].get<std::string>());
    }
}

ordered_json animations_json(const gltf::Contents& contents) {
    ordered_json list = ordered_json::array();
    for (const auto& animation : contents.animations)
        list.push_back({{"name", animation.name},
                        {"duration [s]", animation.duration},
                        {"channels", animation.channels}});
    return list;
}

/// Every extension that the file names, and whether it is required and honoured.
ordered_json extensions_json(const gltf::Contents& contents) {
    ordered_json list = ordered_json::array();
    for (const std::string& name : contents.extensions_used)
        list.push_back({{"name", name},
                        {"required", std::ranges::count(contents.extensions_required, name) > 0},
                        {"honoured", gltf::is_supported(name)}});
    return list;
}

/// Counts the materials of each BRDF, and says how the analytic estimator treats it.
ordered_json brdfs_json(const scene::Scene& s) {
    std::map<std::string, int> count;
    for (const scene::Material& material : s.materials) {
        scene::Mesh mesh;
        if (scene::needs_tangents(material)) mesh.tangents.emplace_back(1.0f);
        scene::Scene alone;
        alone.materials.push_back(material);
        std::string text = scene::describe(material);
        if (scene::brdf_model(material.model).is_delta)
            text += " (sees emitters that have an extent; points and parallel light have none)";
        else if (!material.is_unlit && !render::shading_features(alone, mesh, {}).is_analytic())
            text += " (sampled under --estimator analytic too)";
        ++count[text];
    }
    ordered_json list = ordered_json::array();
    for (const auto& [text, n] : count) list.push_back(fmt::format("{} {}", n, text));
    return list;
}

ordered_json scene_json(const std::string& file, bool is_strict) {
    gltf::LoadOptions options;
    options.is_strict = is_strict;
    const gltf::Loaded loaded = gltf::load(file, options);
    const scene::Scene& s = loaded.scene;
    const scene::Bounds bounds = scene::bounds_of(s);
    ordered_json cameras = ordered_json::array(), lights = ordered_json::array();
    for (const scene::Camera& camera : s.cameras) cameras.push_back(camera.name);
    for (const scene::Light& light : scene::emitters_of(s)) lights.push_back(describe(light, s));
    if (s.environment) lights.push_back(describe(*s.environment, s));
    ordered_json json{{"file", file},
                      {"meshes", s.meshes.size()},
                      {"instances", s.instances.size()},
                      {"triangles", scene::triangle_count(s)},
                      {"materials", s.materials.size()},
                      {"brdfs", brdfs_json(s)},
                      {"textures", s.textures.size()},
                      {"images", s.images.size()},
                      {"unit", scene::radiance_unit(s.units)},
                      {"cameras", cameras},
                      {"lights", lights},
                      {"skins", loaded.contents.skins},
                      {"morph_targets", loaded.contents.morph_targets},
                      {"animations", animations_json(loaded.contents)},
                      {"variants", loaded.contents.variants},
                      {"extensions", extensions_json(loaded.contents)},
                      {"warnings", loaded.warnings}};
    if (!bounds.is_empty()) {
        const auto place = [&](vec3 p) { // in the file's world
            if (s.origin == glm::dvec3(0.0)) return ordered_json{p.x, p.y, p.z};
            const glm::dvec3 world = s.origin + glm::dvec3(p);
            return ordered_json{world.x, world.y, world.z};
        };
        json["bounds [m]"] = {{"min", place(bounds.min)}, {"max", place(bounds.max)}};
    }
    return json;
}

/// "name: value" lines; lists one entry a line.
void print_scene(const ordered_json& json) {
    for (const auto& [key, value] : json.items()) {
        if (!value.is_array() && !value.is_object())
            print_data("{:<22} {}\n", key,
                       value.is_string() ? shown(value.get<std::string>()) : value.dump());
        else if (value.empty())
            print_data("{:<22} none\n", key);
        else
            for (const auto& [name, entry] : value.items())
                print_data("{:<22} {}{}\n", key, value.is_object() ? name + " " : "",
                           shown(key == "lights" ? line_of(entry) : text_of(entry)));
    }
}

} // namespace

void add_info_command(CLI::App& app) {
    struct Arguments {
        std::string scene;
        bool json = false;
        RenderSettings settings;
    };
    const auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand(
        "info", "list the contents of a scene; without a scene, list the OpenGL backends of this machine");
    command->add_option("SCENE", arguments->scene, "a .gltf or .glb file");
    command->add_flag("--json", arguments->json, "print JSON");
    declare(*command, settings::by_info, arguments->settings);
    command->footer("Examples:\n  steradian info\n  steradian info scene.glb\n  steradian info scene.glb "
                    "--json | jq .lights");
    command->callback([arguments] {
        const bool is_scene = !arguments->scene.empty();
        const ordered_json json =
            is_scene ? scene_json(arguments->scene, arguments->settings.is_strict) : backends_json();
        if (arguments->json)
            write_json(json.dump(2, ' ', false, ordered_json::error_handler_t::replace));
        else if (is_scene)
            print_scene(json);
        else
            print_backends(json);
    });
}

} // namespace sr::cli
