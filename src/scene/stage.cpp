#include "scene/stage.hpp"

#include "core/error.hpp"
#include "scene/emitters.hpp"
#include "scene/framing.hpp"
#include "scene/light_surfaces.hpp"
#include "scene/look_at.hpp"
#include "scene/own_light.hpp"
#include "scene/rig.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace sr::scene {
namespace {

/// What the camera at this place of Scene::cameras is called, where it has no name.
int number_of(const Scene& scene, std::size_t place) {
    const int number = scene.cameras[place].number;
    return number >= 0 ? number : static_cast<int>(place);
}

std::string cameras_of(const Scene& scene) {
    std::string names;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        names += fmt::format("{} '{}', ", number_of(scene, i), scene.cameras[i].name);
    return names + "auto, or a view: eye=X,Y,Z;target=X,Y,Z";
}

/// A scene of nothing but the corners of a box.
Scene corners_of(const Bounds& box) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.emplace_back((corner & 1) != 0 ? box.max.x : box.min.x,
                                    (corner & 2) != 0 ? box.max.y : box.min.y,
                                    (corner & 4) != 0 ? box.max.z : box.min.z);
    scene.instances.emplace_back();
    return scene;
}

Camera chosen_camera(const Scene& scene, const std::string& file, const StageOptions& options) {
    const std::string& wanted = options.camera;
    if (wanted == "auto" || (wanted.empty() && scene.cameras.empty()))
        return options.extent && !options.extent->is_empty()
                   ? framing_camera(corners_of(*options.extent), options.aspect_ratio)
                   : framing_camera(scene, options.aspect_ratio);
    if (wanted.empty()) return scene.cameras.front();
    if (is_look_at(wanted))
        return camera_at(parsed_look_at(wanted, scene.origin), bounds_of(scene), options.aspect_ratio);
    for (const Camera& camera : scene.cameras)
        if (camera.name == wanted) return camera;
    int number = 0;
    const auto [end, failure] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        if (failure == std::errc{} && end == wanted.data() + wanted.size() && number == number_of(scene, i))
            return scene.cameras[i];
    throw Error({file}, fmt::format("no camera '{}'", wanted), "choose one of " + cameras_of(scene));
}

/// Whether almost nothing of what the camera sees would be lit.
bool is_dark(const Stage& stage, const Scene& scene, float aspect_ratio) {
    if (stage.lights.empty()) return true;
    const auto share = lit_share(scene, stage.lights, stage.camera, aspect_ratio);
    return share && *share < min_lit_share(scene);
}

/// Whether a surface is there that takes light to be seen.
bool needs_light(const Scene& scene) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        return !is_unlit(mesh, scene.materials[static_cast<std::size_t>(mesh.material)]);
    });
}

void add_rig(Stage& stage, const Scene& scene, const std::string& name, const StageOptions& options) {
    const bool judges = options.rig == Rig::automatic || options.rig == Rig::none;
    const bool dark = judges && needs_light(scene) && is_dark(stage, scene, options.aspect_ratio);
    stage.rig = options.rig != Rig::automatic ? options.rig : dark ? Rig::studio : Rig::none;
    if (stage.rig == Rig::studio) stage.lights.emplace_back(studio(stage.camera));
    if (stage.rig == Rig::softboxes)
        for (RectangleLight& light : softbox_rig(options.extent.value_or(bounds_of(scene)), stage.camera))
            stage.lights.emplace_back(std::move(light));
    if (!dark) return;
    const std::string why = stage.lights.size() == (stage.rig == Rig::studio ? 1u : 0u)
                                ? "no lamp in this file"
                                : "the file's own light leaves it almost dark";
    stage.remarks.push_back(
        stage.rig == Rig::studio
            ? fmt::format("{}: {}: a studio lights it (--rig none leaves it so)", name, why)
            : fmt::format("{}: {}: almost nothing is lit (--rig studio lights it)", name, why));
}

/// Says what pictures of glass leave out.
void remark_on_glass(const Scene& scene, const std::string& name, std::vector<std::string>& remarks) {
    const auto count = std::ranges::count_if(scene.materials, &Material::is_transmissive);
    if (count > 0)
        remarks.push_back(fmt::format("{}: light goes straight through the glass of {} material{}: it is not "
                                      "refracted, and rough glass does not blur it",
                                      name, count, count == 1 ? "" : "s"));
}

/// Says what pictures of points and lines leave out.
void remark_on_lines(const Scene& scene, const std::string& name, std::vector<std::string>& remarks) {
    const auto count =
        std::ranges::count_if(scene.meshes, [](const Mesh& mesh) { return !mesh.is_surface(); });
    if (count > 0)
        remarks.push_back(fmt::format("{}: {} mesh{} points or lines: they are drawn 3 pixels wide at every "
                                      "distance, and cast no shadows",
                                      name, count, count == 1 ? " is" : "es are"));
}

} // namespace

Stage set_stage(Scene scene, const std::string& name, const StageOptions& options) {
    Stage stage;
    stage.camera = chosen_camera(scene, name, options);

    stage.lights = assign_emitters(scene);
    if (const auto& environment = options.environment ? options.environment : scene.environment) {
        EnvironmentLight light = *environment;
        light.is_visible = light.is_visible && !options.hide_emitters;
        stage.lights.emplace_back(std::move(light));
    }
    remark_on_glass(scene, name, stage.remarks);
    remark_on_lines(scene, name, stage.remarks);
    add_rig(stage, scene, name, options);
    if (options.hide_emitters)
        for (Material& material : scene.materials) material.emission = vec3(0.0f);
    else
        add_light_surfaces(scene);
    stage.scene = std::move(scene);
    return stage;
}

} // namespace sr::scene
