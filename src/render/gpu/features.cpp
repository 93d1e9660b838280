#include "render/gpu/features.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <functional>

namespace sr::render {
namespace {

template<class T, class... Others>
constexpr bool is_any_of = (std::is_same_v<T, Others> || ...);

template<class L>
void ask_for_light(Features& f, const L& light) {
    bool is_sphere = false;
    if constexpr (requires { light.position; }) is_sphere = light.radius > 0.0f;
    (is_sphere ? f.has<scene::SphereLight>() : f.has<L>()) = true;
    if constexpr (requires { light.profile; }) f.has_profiles |= light.profile >= 0;
    if constexpr (requires { light.angular_radius; }) f.has_sun_disks |= light.angular_radius > 0.0f;
    if constexpr (requires { light.texture; }) f.has_emission_maps |= light.texture >= 0;
    if constexpr (std::is_same_v<L, scene::EnvironmentLight>)
        f.has_environment_maps |= light.map && light.map->has_light();
    else if constexpr (requires { light.map; })
        f.has_emission_maps |= light.map.is_present();
}

// A member of Features that GLSL has as `const bool` of the same name.
struct Flag {
    const char* name;
    bool Features::*member;
};

constexpr std::array light_flags{Flag{"has_sun_disks", &Features::has_sun_disks},
                                 Flag{"has_profiles", &Features::has_profiles},
                                 Flag{"has_emission_maps", &Features::has_emission_maps},
                                 Flag{"has_environment_maps", &Features::has_environment_maps}};

constexpr std::array other_flags{
    Flag{"has_packed_metallic_roughness", &Features::has_packed_metallic_roughness},
    Flag{"has_second_uv", &Features::has_second_uv},
    Flag{"has_vertex_colors", &Features::has_vertex_colors},
    Flag{"has_energy_compensation", &Features::has_energy_compensation},
    Flag{"is_opaque_part", &Features::is_opaque_part},
    Flag{"is_specular_glossiness", &Features::is_specular_glossiness},
    Flag{"has_transparent_casters", &Features::has_transparent_casters},
    Flag{"has_tinted_casters", &Features::has_tinted_casters},
    Flag{"is_masked", &Features::is_masked},
    Flag{"is_blended", &Features::is_blended},
    Flag{"is_unlit", &Features::is_unlit},
    Flag{"is_line", &Features::is_line},
    Flag{"is_point", &Features::is_point}};

/// Sets the features that the layers of the material need on this mesh.
void ask_for_layers(Features& f, const scene::Material& material, const scene::Mesh& mesh) {
    for (std::size_t i = 0; i < scene::layer_count; ++i) {
        const scene::MaterialLayer& layer = scene::material_layers[i];
        f.has_layer[i] = layer.is_of(material) && (!layer.needs_tangents || !mesh.tangents.empty())
                         && (!layer.needs_surface || mesh.is_surface());
    }
}

/// Sets the textures of the material that shading reads. It does not read those of an absent layer.
void ask_for_textures(Features& f, const scene::Material& material, bool has_tangents) {
    using M = scene::Material;
    for (std::size_t slot = 0; slot < scene::slot_count; ++slot)
        f.has_texture[slot] = (material.*scene::texture_inputs[slot].member).is_present();
    f.has(&M::normal_texture) &= has_tangents;
    f.has(&M::clearcoat_normal_texture) &= has_tangents;
    f.has(&M::emission_texture) &= material.is_emissive();
    for (std::size_t i = 0; i < scene::layer_count; ++i)
        for (const auto texture : scene::material_layers[i].textures)
            if (texture) f.has(texture) &= f.has_layer[i];
}

/// True if the material is no metal, has nothing specular, and no layer.
bool is_matte(const scene::Material& material, const Features& f) {
    return material.model == scene::Model::metallic_roughness && !material.is_specular_glossiness
           && material.metallic == 0.0f && material.specular == 0.0f
           && std::ranges::none_of(f.has_layer, std::identity{});
}

/// True if `is_so` holds for the material of an instance of the scene.
template<class Predicate>
bool any_material(const scene::Scene& scene, Predicate is_so) {
    return std::ranges::any_of(scene.instances, [&](const scene::Instance& instance) {
        const auto material =
            static_cast<std::size_t>(scene.meshes[static_cast<std::size_t>(instance.mesh)].material);
        return is_so(scene.materials[material]);
    });
}

/// Lights, their textures, five of the casters, the fitted lobes; an environment.
int units_of_lights_and_shadows(const Features& features) { return features.has_environment_maps ? 9 : 8; }

/// True if a texture that is read has the second set of coordinates.
bool reads_second_uv(const Features& features, const scene::Material& material) {
    for (std::size_t slot = 0; slot < scene::slot_count; ++slot)
        if (features.has_texture[slot] && (material.*scene::texture_inputs[slot].member).texcoord != 0)
            return true;
    return false;
}

} // namespace

std::string Features::glsl() const {
    std::string text;
    const auto append = [&](const auto& flags) {
        for (const Flag& flag : flags)
            text += fmt::format("const bool {} = {};\n", flag.name, this->*flag.member);
    };
    for (std::size_t kind = 0; kind < scene::light_kind_count; ++kind) {
        const std::string_view name = scene::light_kind_names()[kind];
        text += fmt::format("const int {0}_light = {1};\nconst bool has_{0}_lights = {2};\n", name, kind,
                            has_lights[kind]);
    }
    text += fmt::format("const int light_kinds = {};\n", scene::light_kind_count);
    append(light_flags);
    for (std::size_t slot = 0; slot < scene::slot_count; ++slot)
        text += fmt::format("const bool has_{}_texture = {};\n", scene::texture_inputs[slot].name,
                            has_texture[slot]);
    for (std::size_t i = 0; i < scene::layer_count; ++i)
        text += fmt::format("const bool {} = {};\n", scene::material_layers[i].flag, has_layer[i]);
    append(other_flags);
    text += fmt::format("const bool is_mirror = {};\n", scene::brdf_model(model).is_delta);
    text += fmt::format("const bool is_lambert = {};\n", model == scene::Model::lambert);
    return text + fmt::format("const int rays_per_light = {};\n", rays_per_light);
}

bool Features::is_analytic() const {
    bool is_layered = false; // with a layer that has no closed form
    for (std::size_t i = 0; i < scene::layer_count; ++i)
        is_layered |= has_layer[i] && !scene::material_layers[i].has_analytic_form;
    const scene::BrdfModel& brdf = scene::brdf_model(model);
    return brdf.is_analytic && !(brdf.has_microfacets && is_layered);
}

int Features::material_texture_count() const {
    return static_cast<int>(std::ranges::count(has_texture, true));
}

Features light_features(std::span<const scene::Light> lights) {
    Features f;
    for (const scene::Light& light : lights)
        std::visit([&f](const auto& any) { ask_for_light(f, any); }, light);
    // Lights that a direction sampled from the BRDF can hit. Keep in sync with has_lights_to_meet in
    // shaders/light/sample_light.glsl.
    bool has_lights_to_meet = f.has_sun_disks;
    scene::for_each_light_kind([&]<class L>(std::type_identity<L>) {
        constexpr bool is_met =
            !is_any_of<L, scene::PointLight, scene::SpotLight, scene::DirectionalLight, scene::MeshLight>;
        has_lights_to_meet |= is_met && f.has<L>();
    });
    f.rays_per_light = has_lights_to_meet ? 2 : 1;
    return f;
}

bool has_transparent_casters(const scene::Scene& scene) {
    return any_material(scene, [](const scene::Material& m) {
        return m.alpha_mode != scene::AlphaMode::opaque || m.is_transmissive();
    });
}

bool has_tinted_casters(const scene::Scene& scene) {
    return any_material(scene, [](const scene::Material& m) { return m.is_transmissive(); });
}

Features shading_features(const scene::Scene& scene, const scene::Mesh& mesh, const Features& lights) {
    const scene::Material& material = scene.materials[mesh.material];
    Features f = lights;
    f.has_vertex_colors = !mesh.colors.empty();
    f.model = material.model;
    f.is_specular_glossiness = material.is_specular_glossiness;
    f.has_energy_compensation &= scene::brdf_model(material.model).has_microfacets;
    ask_for_layers(f, material, mesh);
    f.is_matte = is_matte(material, f);
    ask_for_textures(f, material, !mesh.tangents.empty());
    f.has_second_uv = reads_second_uv(f, material);
    f.is_masked = material.alpha_mode == scene::AlphaMode::mask;
    f.is_blended = material.alpha_mode == scene::AlphaMode::blend;
    f.is_unlit = scene::is_unlit(mesh, material);
    f.is_line = !mesh.lines.empty();
    f.is_point = !mesh.points.empty();
    return f;
}

void require_texture_units(const Features& features, std::string_view material, int units) {
    const int count = features.material_texture_count(), besides = units_of_lights_and_shadows(features);
    if (count + besides <= units) return;
    throw Error(fmt::format("material \"{}\" reads {} textures, this driver has room for {}", material, count,
                            units - besides),
                "take a texture of its clearcoat, sheen or iridescence away");
}

bool has_room_for_mesh(const Features& features, int units) {
    constexpr int of_mesh = 3; // its arrays, its indices, the triangles that pixels see
    return features.material_texture_count() + units_of_lights_and_shadows(features) + of_mesh <= units;
}

Features depth_features(const Features& shading) {
    Features f = caster_features(shading);
    if (!shading.is_opaque_part) return f;
    f.has(scene::Layer::transmission) = f.is_opaque_part = true;
    f.has_second_uv = shading.has_second_uv;
    for (const auto texture :
         {&scene::Material::transmission_texture, &scene::Material::metallic_roughness_texture})
        f.has(texture) = shading.has(texture);
    return f;
}

Features caster_features(const Features& shading) {
    Features f;
    f.is_line = shading.is_line;
    f.is_point = shading.is_point;
    if (!shading.is_masked && !shading.is_blended) return f;
    f.is_masked = shading.is_masked;
    f.is_blended = shading.is_blended;
    f.has(&scene::Material::base_color_texture) = shading.has(&scene::Material::base_color_texture);
    f.has_second_uv = shading.has_second_uv;
    f.has_vertex_colors = shading.has_vertex_colors;
    return f;
}

} // namespace sr::render
