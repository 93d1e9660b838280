#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/light_description.hpp"
#include "cli/version.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "gl/context.hpp"
#include "gltf/extensions.hpp"
#include "gltf/load.hpp"
#include "render/gpu/features.hpp"
#include "scene/material_description.hpp"
#include "scene/prepare.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;

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
        std::string text = scene::described(material);
        if (material.model == scene::Model::mirror)
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
    for (const scene::Light& light : scene::emitters_of(s)) lights.push_back(described(light, s));
    if (s.environment) lights.push_back(described(*s.environment, s));
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
    CLI::App* command =
        app.add_subcommand("info", "what a scene holds; without a scene, what OpenGL this machine offers");
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
