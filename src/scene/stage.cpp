#include "scene/stage.hpp"

#include "core/error.hpp"
#include "scene/emitters.hpp"
#include "scene/framing.hpp"
#include "scene/light_surfaces.hpp"
#include "scene/look_at.hpp"
#include "scene/rig.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace sr::scene {
namespace {

std::string cameras_of(const Scene& scene) {
    std::string names;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        names += fmt::format("{} '{}', ", i, scene.cameras[i].name);
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
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
    if (failure == std::errc{} && end == wanted.data() + wanted.size() && index < scene.cameras.size())
        return scene.cameras[index];
    throw Error({file}, fmt::format("no camera '{}'", wanted), "choose one of " + cameras_of(scene));
}

/// Whether a light is the glow of a model's details, as emissive textures are mostly painted, and no lamp.
bool is_detail(const Light& light) {
    const auto* mesh = std::get_if<MeshLight>(&light);
    return mesh && mesh->texture >= 0;
}

/// Says what pictures of glass leave out.
void remark_on_glass(const Scene& scene, const std::string& name, std::vector<std::string>& remarks) {
    const auto count = std::ranges::count_if(scene.materials, &Material::is_transmissive);
    if (count > 0)
        remarks.push_back(fmt::format("{}: light goes straight through the glass of {} material{}: it is not "
                                      "refracted, and rough glass does not blur it",
                                      name, count, count == 1 ? "" : "s"));
}

} // namespace

Stage set_stage(Scene scene, const std::string& name, const StageOptions& options) {
    Stage stage;
    const Bounds bounds = options.extent.value_or(bounds_of(scene));
    stage.camera = chosen_camera(scene, name, options);

    stage.lights = assign_emitters(scene);
    if (std::ranges::all_of(stage.lights, is_detail) && options.rig == Rig::studio) {
        for (RectangleLight& light : studio_rig(bounds, stage.camera))
            stage.lights.emplace_back(std::move(light));
        stage.remarks.push_back(fmt::format("{}: no lamp in this file: lit by three studio softboxes "
                                            "(--rig none leaves it dark)",
                                            name));
    }
    remark_on_glass(scene, name, stage.remarks);
    if (options.hide_emitters)
        for (Material& material : scene.materials) material.emission = vec3(0.0f);
    else
        add_light_surfaces(scene);
    stage.scene = std::move(scene);
    return stage;
}

} // namespace sr::scene
