#include "render/features.hpp"

#include <fmt/format.h>

namespace sr::render {

std::string Features::glsl() const {
    std::string text;
    const auto constant = [&](const char* name, bool value) {
        text += fmt::format("const bool {} = {};\n", name, value);
    };
    constant("has_point_lights", has_point_lights);
    constant("has_spot_lights", has_spot_lights);
    constant("has_directional_lights", has_directional_lights);
    constant("has_rectangle_lights", has_rectangle_lights);
    constant("has_base_color_texture", has_base_color_texture);
    constant("has_metallic_roughness_texture", has_metallic_roughness_texture);
    constant("has_normal_texture", has_normal_texture);
    constant("has_emission_texture", has_emission_texture);
    constant("has_specular_texture", has_specular_texture);
    constant("has_specular_color_texture", has_specular_color_texture);
    constant("has_vertex_colors", has_vertex_colors);
    constant("is_masked", is_masked);
    constant("is_blended", is_blended);
    constant("is_unlit", is_unlit);
    return text;
}

Features shading_features(const scene::Scene& scene, const scene::Mesh& mesh,
                          std::span<const scene::Light> lights) {
    const scene::Material& material = scene.materials[mesh.material];
    Features f;
    for (const scene::Light& light : lights) {
        f.has_point_lights |= std::holds_alternative<scene::PointLight>(light);
        f.has_spot_lights |= std::holds_alternative<scene::SpotLight>(light);
        f.has_directional_lights |= std::holds_alternative<scene::DirectionalLight>(light);
        f.has_rectangle_lights |= std::holds_alternative<scene::RectangleLight>(light);
    }
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
    Features f;
    if (!shading.is_masked) return f;
    f.is_masked = true;
    f.has_base_color_texture = shading.has_base_color_texture;
    f.has_vertex_colors = shading.has_vertex_colors;
    return f;
}

} // namespace sr::render
