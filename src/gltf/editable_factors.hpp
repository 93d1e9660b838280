#pragma once
// Factors of a material that a person can edit besides base colour, metallic and roughness, and where glTF
// has them.
#include "scene/material.hpp"

#include <array>
#include <map>
#include <string_view>
#include <variant>

namespace sr::gltf {

struct EditableFactor {
    std::string_view key; // in journals; the name of the member
    std::string_view label;
    std::string_view group;   // of fields: a property of the surface
    std::string_view meaning; // with its unit and its texture
    std::string_view pointer; // JSON pointer within the material
    std::variant<float scene::Material::*, vec3 scene::Material::*> member; // a vec3 is a linear colour
    float min = 0.0f;
    float max = 1.0f;
    bool is_logarithmic = false; // a slider has small values as well as large ones
    /// True if a material has it or could have it. Shading would not notice it on others.
    bool (*is_of)(const scene::Material&);
};

/// Values of factors by their place in the table; of a number in x.
using FactorValues = std::map<std::size_t, vec3>;

namespace detail {
using M = scene::Material;

constexpr bool is_layered(const M& m) {
    return m.model == scene::Model::metallic_roughness && !m.is_specular_glossiness && !m.is_unlit;
}

/// True if meshes of the material have tangents from the start.
inline bool has_tangents(const M& m) { return m.normal_texture.is_present() || m.is_anisotropic(); }

/// A coat with a normal map needs tangents.
inline bool can_have_coat(const M& m) {
    return is_layered(m)
           && (!m.clearcoat_normal_texture.is_present() || m.clearcoat > 0.0f || has_tangents(m));
}
} // namespace detail

/// All of them, group by group. Anisotropy is for materials whose meshes have tangents: some of their own, or
/// for a normal map.
inline constexpr std::array editable_factors = [] {
    using detail::can_have_coat;
    using detail::has_tangents;
    using detail::is_layered;
    using detail::M;
    return std::array{
        EditableFactor{.key = "normal_scale",
                       .label = "normal scale",
                       .group = "surface",
                       .meaning = "factor of the normal map's slopes; 0: flat",
                       .pointer = "/normalTexture/scale",
                       .member = &M::normal_scale,
                       .max = 4.0f,
                       .is_of = [](const M& m) { return m.normal_texture.is_present() && !m.is_unlit; }},
        EditableFactor{.key = "alpha_cutoff",
                       .label = "alpha cutoff",
                       .group = "surface",
                       .meaning = "the least alpha that is seen; below it nothing is there",
                       .pointer = "/alphaCutoff",
                       .member = &M::alpha_cutoff,
                       .is_of = [](const M& m) { return m.alpha_mode == scene::AlphaMode::mask; }},
        EditableFactor{.key = "ior",
                       .label = "ior",
                       .group = "surface",
                       .meaning = "index of refraction of the dielectric, 1.5: F0 is 0.04",
                       .pointer = "/extensions/KHR_materials_ior/ior",
                       .member = &M::ior,
                       .min = 1.0f,
                       .max = 3.0f,
                       .is_of = is_layered},
        EditableFactor{.key = "specular",
                       .label = "specular",
                       .group = "surface",
                       .meaning = "weight of the dielectric's reflection, times the alpha of its texture",
                       .pointer = "/extensions/KHR_materials_specular/specularFactor",
                       .member = &M::specular,
                       .is_of = is_layered},
        EditableFactor{.key = "specular_color",
                       .label = "specular colour",
                       .group = "surface",
                       .meaning = "colour of the dielectric's F0, linear, times its texture",
                       .pointer = "/extensions/KHR_materials_specular/specularColorFactor",
                       .member = &M::specular_color,
                       .is_of = is_layered},
        EditableFactor{.key = "anisotropy",
                       .label = "anisotropy",
                       .group = "anisotropy",
                       .meaning = "strength, times the blue channel of its texture",
                       .pointer = "/extensions/KHR_materials_anisotropy/anisotropyStrength",
                       .member = &M::anisotropy,
                       .is_of = [](const M& m) { return is_layered(m) && has_tangents(m); }},
        EditableFactor{.key = "anisotropy_rotation",
                       .label = "rotation",
                       .group = "anisotropy",
                       .meaning = "from the tangent towards the bitangent [rad]",
                       .pointer = "/extensions/KHR_materials_anisotropy/anisotropyRotation",
                       .member = &M::anisotropy_rotation,
                       .min = -pi,
                       .max = pi,
                       .is_of = [](const M& m) { return is_layered(m) && has_tangents(m); }},
        EditableFactor{.key = "clearcoat",
                       .label = "clearcoat",
                       .group = "clearcoat",
                       .meaning = "weight of a coat of lacquer, times the red channel of its texture",
                       .pointer = "/extensions/KHR_materials_clearcoat/clearcoatFactor",
                       .member = &M::clearcoat,
                       .is_of = can_have_coat},
        EditableFactor{.key = "clearcoat_roughness",
                       .label = "its roughness",
                       .group = "clearcoat",
                       .meaning = "roughness of the coat, times the green channel of its texture",
                       .pointer = "/extensions/KHR_materials_clearcoat/clearcoatRoughnessFactor",
                       .member = &M::clearcoat_roughness,
                       .is_of = is_layered},
        EditableFactor{
            .key = "clearcoat_normal_scale",
            .label = "its normal scale",
            .group = "clearcoat",
            .meaning = "factor of the slopes of the coat's normal map",
            .pointer = "/extensions/KHR_materials_clearcoat/clearcoatNormalTexture/scale",
            .member = &M::clearcoat_normal_scale,
            .max = 4.0f,
            .is_of = [](const M& m) { return is_layered(m) && m.clearcoat_normal_texture.is_present(); }},
        EditableFactor{.key = "sheen_color",
                       .label = "sheen colour",
                       .group = "sheen",
                       .meaning =
                           "what fibres scatter at grazing angles, linear, times its texture; black: none",
                       .pointer = "/extensions/KHR_materials_sheen/sheenColorFactor",
                       .member = &M::sheen_color,
                       .is_of = is_layered},
        EditableFactor{.key = "sheen_roughness",
                       .label = "its roughness",
                       .group = "sheen",
                       .meaning = "roughness of the sheen, times the alpha of its texture",
                       .pointer = "/extensions/KHR_materials_sheen/sheenRoughnessFactor",
                       .member = &M::sheen_roughness,
                       .is_of = is_layered},
        EditableFactor{.key = "iridescence",
                       .label = "thin film",
                       .group = "thin film",
                       .meaning = "weight of the film, times the red channel of its texture",
                       .pointer = "/extensions/KHR_materials_iridescence/iridescenceFactor",
                       .member = &M::iridescence,
                       .is_of = is_layered},
        EditableFactor{.key = "film_ior",
                       .label = "its ior",
                       .group = "thin film",
                       .meaning = "index of refraction of the film",
                       .pointer = "/extensions/KHR_materials_iridescence/iridescenceIor",
                       .member = &M::film_ior,
                       .min = 1.0f,
                       .max = 3.0f,
                       .is_of = is_layered},
        EditableFactor{
            .key = "min_film_thickness",
            .label = "its least thickness",
            .group = "thin film",
            .meaning = "thickness of the film [nm], where its texture's green channel is 0",
            .pointer = "/extensions/KHR_materials_iridescence/iridescenceThicknessMinimum",
            .member = &M::min_film_thickness,
            .max = 2000.0f,
            .is_of = [](const M& m) { return is_layered(m) && m.film_thickness_texture.is_present(); }},
        EditableFactor{
            .key = "max_film_thickness",
            .label = "its thickness",
            .group = "thin film",
            .meaning = "thickness of the film [nm], where its texture's green channel is 1 or there is none",
            .pointer = "/extensions/KHR_materials_iridescence/iridescenceThicknessMaximum",
            .member = &M::max_film_thickness,
            .max = 2000.0f,
            .is_of = is_layered},
        EditableFactor{.key = "transmission",
                       .label = "transmission",
                       .group = "transmission",
                       .meaning =
                           "share of the base that lets light through, times the red channel of its texture",
                       .pointer = "/extensions/KHR_materials_transmission/transmissionFactor",
                       .member = &M::transmission,
                       .is_of = is_layered},
        EditableFactor{
            .key = "thickness",
            .label = "thickness",
            .group = "transmission",
            .meaning =
                "way of the light below the surface [m] of the mesh, times its texture's green channel",
            .pointer = "/extensions/KHR_materials_volume/thicknessFactor",
            .member = &M::thickness,
            .max = 100.0f,
            .is_logarithmic = true,
            .is_of = [](const M& m) { return m.is_transmissive(); }},
        EditableFactor{.key = "attenuation_distance",
                       .label = "attenuation",
                       .group = "transmission",
                       .meaning = "distance [m] over which white light becomes the attenuation colour",
                       .pointer = "/extensions/KHR_materials_volume/attenuationDistance",
                       .member = &M::attenuation_distance,
                       .min = 1e-3f,
                       .max = 1e3f,
                       .is_logarithmic = true,
                       .is_of = [](const M& m) { return m.is_transmissive(); }},
        EditableFactor{.key = "attenuation_color",
                       .label = "attenuation colour",
                       .group = "transmission",
                       .meaning = "what is left of white light after that distance, linear",
                       .pointer = "/extensions/KHR_materials_volume/attenuationColor",
                       .member = &M::attenuation_color,
                       .is_of = [](const M& m) { return m.is_transmissive(); }},
        EditableFactor{.key = "diffuse_transmission",
                       .label = "diffuse",
                       .group = "transmission",
                       .meaning =
                           "share that scatters light from behind, as a leaf does, times its texture's alpha",
                       .pointer = "/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionFactor",
                       .member = &M::diffuse_transmission,
                       .is_of = is_layered},
        EditableFactor{.key = "diffuse_transmission_color",
                       .label = "its colour",
                       .group = "transmission",
                       .meaning = "colour of the light that it scatters, linear, times its texture",
                       .pointer =
                           "/extensions/KHR_materials_diffuse_transmission/diffuseTransmissionColorFactor",
                       .member = &M::diffuse_transmission_color,
                       .is_of = is_layered}};
}();

/// The value of a factor; of a number in x.
inline vec3 value_of(const EditableFactor& factor, const scene::Material& material) {
    if (const auto* number = std::get_if<float scene::Material::*>(&factor.member))
        return vec3(material.**number, 0.0f, 0.0f);
    return material.*std::get<vec3 scene::Material::*>(factor.member);
}

inline void set_value(const EditableFactor& factor, scene::Material& material, vec3 value) {
    if (const auto* number = std::get_if<float scene::Material::*>(&factor.member))
        material.** number = value.x;
    else
        material.*std::get<vec3 scene::Material::*>(factor.member) = value;
}

} // namespace sr::gltf
