#include "scene/material.hpp"

#include <algorithm>

namespace sr::scene {

std::optional<Model> model_named(std::string_view name) {
    const auto found = std::ranges::find(brdf_models, name, &BrdfModel::name);
    if (found == brdf_models.end()) return std::nullopt;
    return static_cast<Model>(found - brdf_models.begin());
}

std::string models_with(const BrdfParameter& parameter, std::string_view between) {
    const auto [first, second] = parameter.models;
    std::string text(name_of(first));
    if (second != first) text.append(between).append(name_of(second));
    return text;
}

float F0_from_ior(float ior) {
    if (ior == 0.0f) return 1.0f;
    const float r = (ior - 1.0f) / (ior + 1.0f);
    return r * r;
}

float min_opaque_alpha(const Material& material) { return material.alpha_cutoff * (1.0f - 1.0f / 2000.0f); }

vec3 attenuation_coefficient(const Material& m) {
    constexpr float blackest = 1e-30f; // a colour of 0 would be an endless coefficient
    return -glm::log(glm::clamp(m.attenuation_color, vec3(blackest), vec3(1.0f))) / m.attenuation_distance;
}

bool needs_tangents(const Material& m) {
    return m.normal_texture.is_present() || m.is_anisotropic()
           || (m.clearcoat > 0.0f && m.clearcoat_normal_texture.is_present());
}

int tangent_texcoord(const Material& m) {
    for (const TextureSlot* slot : {&m.normal_texture, &m.clearcoat_normal_texture, &m.anisotropy_texture})
        if (slot->is_present()) return slot->texcoord;
    return 0;
}

std::string describe(const Material& m) {
    if (m.is_unlit) return "unlit";
    std::string text(m.is_specular_glossiness ? "specular_glossiness" : name_of(m.model));
    for (const MaterialLayer& layer : material_layers) {
        if (layer.is_of(m)) text.append(", ").append(layer.name);
        if (m.model != Model::metallic_roughness) break; // other models have only the first, anisotropy
    }
    return text;
}

int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::repeat ? size : 2 * size;
    const int m = (i % period + period) % period;
    return m < size ? m : 2 * size - 1 - m;
}

} // namespace sr::scene
