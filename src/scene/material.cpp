#include "scene/material.hpp"

#include <algorithm>
#include <utility>

namespace sr::scene {
namespace {

constexpr std::array<std::pair<std::string_view, Model>, 9> model_names{
    {{"metallic_roughness", Model::metallic_roughness},
     {"lambert", Model::lambert},
     {"oren_nayar", Model::oren_nayar},
     {"mirror", Model::mirror},
     {"phong", Model::phong},
     {"blinn_phong", Model::blinn_phong},
     {"ggx", Model::ggx},
     {"conductor", Model::conductor},
     {"merl", Model::merl}}};

} // namespace

std::string_view name_of(Model model) {
    return std::ranges::find(model_names, model, &decltype(model_names)::value_type::second)->first;
}

std::optional<Model> model_named(std::string_view name) {
    const auto found = std::ranges::find(model_names, name, &decltype(model_names)::value_type::first);
    return found == model_names.end() ? std::nullopt : std::optional(found->second);
}

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

int wrapped(int i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp_to_edge) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::repeat ? size : 2 * size;
    const int m = (i % period + period) % period;
    return m < size ? m : 2 * size - 1 - m;
}

} // namespace sr::scene
