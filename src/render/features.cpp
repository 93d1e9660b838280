#include "render/features.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::render {
namespace {

void ask_for(Features& f, const scene::PointLight& light) {
    (light.radius > 0.0f ? f.has_sphere_lights : f.has_point_lights) = true;
    f.has_profiles |= light.profile >= 0;
}
void ask_for(Features& f, const scene::SpotLight& light) {
    (light.radius > 0.0f ? f.has_sphere_lights : f.has_spot_lights) = true;
}
void ask_for(Features& f, const scene::DirectionalLight& light) {
    f.has_directional_lights = true;
    f.has_sun_disks |= light.angular_radius > 0.0f;
}
void ask_for(Features& f, const scene::RectangleLight& light) {
    f.has_rectangle_lights = true;
    f.has_emission_maps |= light.map.is_present();
}
void ask_for(Features& f, const scene::DiskLight& light) {
    f.has_disk_lights = true;
    f.has_emission_maps |= light.map.is_present();
}
void ask_for(Features& f, const scene::SphereLight&) { f.has_sphere_lights = true; }
void ask_for(Features& f, const scene::TubeLight&) { f.has_tube_lights = true; }
void ask_for(Features& f, const scene::PolygonLight&) { f.has_polygon_lights = true; }
void ask_for(Features& f, const scene::MeshLight& light) {
    f.has_mesh_lights = true;
    f.has_emission_maps |= light.texture >= 0;
}

} // namespace

std::string Features::glsl() const {
    std::string text;
    const auto constant = [&](const char* name, bool value) {
        text += fmt::format("const bool {} = {};\n", name, value);
    };
    constant("has_point_lights", has_point_lights);
    constant("has_spot_lights", has_spot_lights);
    constant("has_directional_lights", has_directional_lights);
    constant("has_rectangle_lights", has_rectangle_lights);
    constant("has_disk_lights", has_disk_lights);
    constant("has_sphere_lights", has_sphere_lights);
    constant("has_tube_lights", has_tube_lights);
    constant("has_polygon_lights", has_polygon_lights);
    constant("has_mesh_lights", has_mesh_lights);
    constant("has_sun_disks", has_sun_disks);
    constant("has_profiles", has_profiles);
    constant("has_emission_maps", has_emission_maps);
    constant("has_base_color_texture", has_base_color_texture);
    constant("has_metallic_roughness_texture", has_metallic_roughness_texture);
    constant("has_normal_texture", has_normal_texture);
    constant("has_emission_texture", has_emission_texture);
    constant("has_specular_texture", has_specular_texture);
    constant("has_specular_color_texture", has_specular_color_texture);
    constant("has_vertex_colors", has_vertex_colors);
    text += fmt::format("const int rays_per_light = {};\n", rays_per_light);
    constant("has_transparent_casters", has_transparent_casters);
    constant("is_masked", is_masked);
    constant("is_blended", is_blended);
    constant("is_unlit", is_unlit);
    return text;
}

Features light_features(std::span<const scene::Light> lights) {
    Features f;
    for (const scene::Light& light : lights) std::visit([&f](const auto& any) { ask_for(f, any); }, light);
    // What a direction of the BRDF's choice can meet: has_lights_to_meet in shaders/light/sample_light.glsl.
    const bool has_lights_to_meet = f.has_rectangle_lights || f.has_disk_lights || f.has_sphere_lights
                                    || f.has_tube_lights || f.has_polygon_lights || f.has_sun_disks;
    f.rays_per_light = has_lights_to_meet ? 2 : 1;
    return f;
}

bool has_transparent_casters(const scene::Scene& scene) {
    return std::ranges::any_of(scene.instances, [&](const scene::Instance& instance) {
        const auto material =
            static_cast<std::size_t>(scene.meshes[static_cast<std::size_t>(instance.mesh)].material);
        return scene.materials[material].alpha_mode != scene::AlphaMode::opaque;
    });
}

Features shading_features(const scene::Scene& scene, const scene::Mesh& mesh, const Features& lights) {
    const scene::Material& material = scene.materials[mesh.material];
    Features f = lights;
    f.has_base_color_texture = material.base_color_texture.is_present();
    f.has_metallic_roughness_texture = material.metallic_roughness_texture.is_present();
    f.has_normal_texture = material.normal_texture.is_present() && !mesh.tangents.empty();
    f.has_emission_texture = material.emission_texture.is_present() && material.is_emissive();
    f.has_specular_texture = material.specular_texture.is_present();
    f.has_specular_color_texture = material.specular_color_texture.is_present();
    f.has_vertex_colors = !mesh.colors.empty();
    f.is_masked = material.alpha_mode == scene::AlphaMode::mask;
    f.is_blended = material.alpha_mode == scene::AlphaMode::blend;
    f.is_unlit = material.is_unlit;
    return f;
}

Features depth_features(const Features& shading) {
    return shading.is_masked ? caster_features(shading) : Features{};
}

Features caster_features(const Features& shading) {
    Features f;
    if (!shading.is_masked && !shading.is_blended) return f;
    f.is_masked = shading.is_masked;
    f.is_blended = shading.is_blended;
    f.has_base_color_texture = shading.has_base_color_texture;
    f.has_vertex_colors = shading.has_vertex_colors;
    return f;
}

} // namespace sr::render
