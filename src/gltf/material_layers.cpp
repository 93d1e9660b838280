// The KHR_materials_ extensions that shape or cover a material's lobes, or let light through.
#include "gltf/material.hpp"
#include "gltf/warnings.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::gltf {

using tinygltf::Value;

void MaterialTable::read_anisotropy(const tinygltf::Material& from, scene::Material& to) {
    const Value* anisotropy = extension(from.extensions, "KHR_materials_anisotropy");
    if (!anisotropy) return;
    to.anisotropy =
        fraction(number_in(*anisotropy, "anisotropyStrength", 0.0), "anisotropyStrength", from.name);
    to.anisotropy_rotation =
        static_cast<float>(within_a_turn(number_in(*anisotropy, "anisotropyRotation", 0.0)));
    read_texture(*anisotropy, "anisotropyTexture", &scene::Material::anisotropy_texture, to);
}

void MaterialTable::read_clearcoat(const tinygltf::Material& from, scene::Material& to) {
    const Value* coat = extension(from.extensions, "KHR_materials_clearcoat");
    if (!coat) return;
    to.clearcoat = fraction(number_in(*coat, "clearcoatFactor", 0.0), "clearcoatFactor", from.name);
    to.clearcoat_roughness =
        fraction(number_in(*coat, "clearcoatRoughnessFactor", 0.0), "clearcoatRoughnessFactor", from.name);
    read_texture(*coat, "clearcoatTexture", &scene::Material::clearcoat_texture, to);
    read_texture(*coat, "clearcoatRoughnessTexture", &scene::Material::clearcoat_roughness_texture, to);
    if (!coat->Has("clearcoatNormalTexture")) return;
    read_texture(*coat, "clearcoatNormalTexture", &scene::Material::clearcoat_normal_texture, to);
    to.clearcoat_normal_scale =
        clamped(number_in(coat->Get("clearcoatNormalTexture"), "scale", 1.0), -steepest_map, steepest_map,
                "clearcoatNormalTexture/scale", from.name);
}

void MaterialTable::read_sheen(const tinygltf::Material& from, scene::Material& to) {
    const Value* sheen = extension(from.extensions, "KHR_materials_sheen");
    if (!sheen) return;
    const vec3 color = not_negative(document_, three_in(*sheen, "sheenColorFactor", vec3(0.0f)),
                                    "sheenColorFactor", from.name);
    for (int i = 0; i < 3; ++i)
        to.sheen_color[i] = fraction(static_cast<double>(color[i]), "sheenColorFactor", from.name);
    to.sheen_roughness =
        fraction(number_in(*sheen, "sheenRoughnessFactor", 0.0), "sheenRoughnessFactor", from.name);
    read_texture(*sheen, "sheenColorTexture", &scene::Material::sheen_color_texture, to);
    read_texture(*sheen, "sheenRoughnessTexture", &scene::Material::sheen_roughness_texture, to);
}

void MaterialTable::read_iridescence(const tinygltf::Material& from, scene::Material& to) {
    const Value* film = extension(from.extensions, "KHR_materials_iridescence");
    if (!film) return;
    to.iridescence = fraction(number_in(*film, "iridescenceFactor", 0.0), "iridescenceFactor", from.name);
    to.film_ior = static_cast<float>(number_in(*film, "iridescenceIor", 1.3));
    to.least_film_thickness = static_cast<float>(number_in(*film, "iridescenceThicknessMinimum", 100.0));
    to.largest_film_thickness = static_cast<float>(number_in(*film, "iridescenceThicknessMaximum", 400.0));
    constexpr float largest_ior = 1000.0f,
                    thickest = 1e9f; // [nm]: a metre is no film, and within, phases are floats
    if (!(to.film_ior >= 1.0f && to.film_ior <= largest_ior))
        document_.fail(fmt::format("material {}: iridescenceIor is {}", in_quotes(from.name), to.film_ior),
                       fmt::format("give 1 to {}", largest_ior));
    for (const float thickness : {to.least_film_thickness, to.largest_film_thickness})
        if (!(thickness >= 0.0f && thickness <= thickest))
            document_.fail(fmt::format("material {}: its film is {} to {} nm thick", in_quotes(from.name),
                                       to.least_film_thickness, to.largest_film_thickness),
                           fmt::format("give 0 to {}", thickest));
    read_texture(*film, "iridescenceTexture", &scene::Material::iridescence_texture, to);
    read_texture(*film, "iridescenceThicknessTexture", &scene::Material::film_thickness_texture, to);
}

vec3 MaterialTable::color(const Value& object, const char* factor, const std::string& material) {
    vec3 color = not_negative(document_, three_in(object, factor, vec3(1.0f)), factor, material);
    for (int i = 0; i < 3; ++i) color[i] = fraction(static_cast<double>(color[i]), factor, material);
    return color;
}

void MaterialTable::read_transmission(const tinygltf::Material& from, scene::Material& to) {
    const Value* transmission = extension(from.extensions, "KHR_materials_transmission");
    if (!transmission) return;
    to.transmission =
        fraction(number_in(*transmission, "transmissionFactor", 0.0), "transmissionFactor", from.name);
    read_texture(*transmission, "transmissionTexture", &scene::Material::transmission_texture, to);
}

void MaterialTable::read_volume(const tinygltf::Material& from, scene::Material& to) {
    const Value* volume = extension(from.extensions, "KHR_materials_volume");
    if (!volume) return;
    to.thickness = static_cast<float>(number_in(*volume, "thicknessFactor", 0.0));
    if (!(to.thickness >= 0.0f))
        document_.fail(fmt::format("material {}: thicknessFactor is {}", in_quotes(from.name), to.thickness),
                       "give zero or more");
    if (volume->Has("attenuationDistance")) {
        const auto distance = static_cast<float>(number_in(*volume, "attenuationDistance", 0.0));
        if (distance > 0.0f)
            to.attenuation_distance = distance;
        else
            warnings_.add(fmt::format("material {}: attenuationDistance is {}, not more than 0",
                                      in_quotes(from.name), distance),
                          "nothing is attenuated");
    }
    to.attenuation_color = color(*volume, "attenuationColor", from.name);
    read_texture(*volume, "thicknessTexture", &scene::Material::thickness_texture, to);
}

void MaterialTable::read_diffuse_transmission(const tinygltf::Material& from, scene::Material& to) {
    const Value* diffuse = extension(from.extensions, "KHR_materials_diffuse_transmission");
    if (!diffuse) return;
    to.diffuse_transmission = fraction(number_in(*diffuse, "diffuseTransmissionFactor", 0.0),
                                       "diffuseTransmissionFactor", from.name);
    to.diffuse_transmission_color = color(*diffuse, "diffuseTransmissionColorFactor", from.name);
    read_texture(*diffuse, "diffuseTransmissionTexture", &scene::Material::diffuse_transmission_texture, to);
    read_texture(*diffuse, "diffuseTransmissionColorTexture",
                 &scene::Material::diffuse_transmission_color_texture, to);
}

} // namespace sr::gltf
