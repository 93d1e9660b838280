#include "shadow/shadow_map_scene.hpp"

namespace sr::shadow {
namespace {

bool reflects(const scene::Material& material) {
    const bool is_black =
        vec3(material.base_color) == vec3(0.0f) && !material.base_color_texture.is_present();
    return !material.is_unlit && !(is_black && material.specular == 0.0f && !material.transmits_diffusely());
}

} // namespace

bool stands_in_light(const Caster& caster, int light) {
    return !(caster.emits_as.contains(light) && caster.own_share == whole_ray);
}

bool is_in_maps(const Caster& caster, int light) {
    return caster.glass < 0 && stands_in_light(caster, light);
}

ShadowMapScene map_stage_of(const scene::Scene& scene, std::span<const scene::Light> lights,
                            const Casters& casters) {
    ShadowMapScene stage;
    stage.lights.assign(lights.begin(), lights.end());
    for (std::size_t i = 0; i < casters.casters.size(); ++i) {
        const auto first = 3 * static_cast<std::size_t>(casters.casters[i].first_triangle);
        const std::size_t end = i + 1 < casters.casters.size()
                                    ? 3 * static_cast<std::size_t>(casters.casters[i + 1].first_triangle)
                                    : casters.corners.size();
        stage.casters.push_back(ball_around(std::span(casters.corners).subspan(first, end - first)));
    }
    stage.all = ball_around(stage.casters);
    for (std::size_t k = 0; k < lights.size(); ++k) {
        std::vector<Ball> receivers;
        for (std::size_t i = 0; i < stage.casters.size(); ++i) {
            const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(scene.instances[i].mesh)];
            if (reflects(scene.materials[static_cast<std::size_t>(mesh.material)])
                && stands_in_light(casters.casters[i], static_cast<int>(k)))
                receivers.push_back(stage.casters[i]);
        }
        stage.receivers.push_back(ball_around(receivers));
    }
    return stage;
}

} // namespace sr::shadow
