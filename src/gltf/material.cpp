#include "gltf/material.hpp"

#include "gltf/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace sr::gltf {
namespace {

using tinygltf::Value;

vec2 two_in(const Value& object, const std::string& key, vec2 fallback) {
    if (!object.Has(key)) return fallback;
    const Value& list = object.Get(key);
    return {static_cast<float>(list.Get(0).GetNumberAsDouble()),
            static_cast<float>(list.Get(1).GetNumberAsDouble())};
}

// KHR_texture_transform: translation * rotation * scale. It turns from +u towards -v for a positive angle:
// counter-clockwise as seen on the image, whose v goes down. (The extension's example, "the lower left
// quadrant rotated clockwise by 90°", holds for this sign only.)
mat3 uv_transform(const Value& transform) {
    constexpr float far =
        1e9f; // beyond, nothing is left of a coordinate's fraction; within, no product overflows
    const vec2 offset = glm::clamp(two_in(transform, "offset", vec2(0.0f)), -far, far);
    const vec2 scale = glm::clamp(two_in(transform, "scale", vec2(1.0f)), -far, far);
    const auto angle = static_cast<float>(within_a_turn(number_in(transform, "rotation", 0.0)));
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    return {vec3(c * scale.x, -s * scale.x, 0.0f), vec3(s * scale.y, c * scale.y, 0.0f), vec3(offset, 1.0f)};
}

scene::AlphaMode alpha_mode_of(const std::string& name) {
    if (name == "MASK") return scene::AlphaMode::mask;
    if (name == "BLEND") return scene::AlphaMode::blend;
    return scene::AlphaMode::opaque;
}

} // namespace

vec3 three_in(const Value& object, const std::string& key, vec3 fallback) {
    if (!object.Has(key)) return fallback;
    const Value& list = object.Get(key);
    for (int i = 0; i < 3; ++i) fallback[i] = static_cast<float>(list.Get(i).GetNumberAsDouble());
    return fallback;
}

double within_a_turn(double angle) { return std::remainder(angle, 2.0 * glm::pi<double>()); }

vec3 within(const Document& document, vec3 value, float most, const char* factor, const std::string& material,
            const char* remedy) {
    for (int i = 0; i < 3; ++i)
        if (!(value[i] >= 0.0f && value[i] <= most))
            document.fail(fmt::format("material {}: {} is {} {} {}", in_quotes(material), factor, value.x,
                                      value.y, value.z),
                          remedy);
    return value;
}

vec3 not_negative(const Document& document, vec3 value, const char* factor, const std::string& material) {
    return within(document, value, std::numeric_limits<float>::max(), factor, material, "give zero or more");
}

MaterialTable::MaterialTable(const Document& document, MeasuredTable& measured, Warnings& warnings)
    : document_(document), measured_(measured), warnings_(warnings), textures_(document, warnings) {}

int MaterialTable::material(int gltf_material) {
    const auto [number, is_new] = number_of_.try_emplace(gltf_material, static_cast<int>(materials_.size()));
    if (is_new)
        materials_.push_back(
            gltf_material < 0
                ? scene::Material{}
                : read(document_.model.materials[static_cast<std::size_t>(gltf_material)], gltf_material));
    return number->second;
}

std::vector<int> MaterialTable::numbers() const {
    std::vector<int> numbers(materials_.size(), -1);
    for (const auto& [in_file, here] : number_of_) numbers[static_cast<std::size_t>(here)] = in_file;
    return numbers;
}

float MaterialTable::clamped(double value, double least, double most, const char* factor,
                             const std::string& material) {
    if (value >= least && value <= most) return static_cast<float>(value);
    warnings_.add(fmt::format("material {}: {} is {}, outside {} to {}", in_quotes(material), factor, value,
                              least, most),
                  "it is clamped");
    return static_cast<float>(std::clamp(value, least, most));
}

float MaterialTable::fraction(double value, const char* factor, const std::string& material) {
    return clamped(value, 0.0, 1.0, factor, material);
}

scene::TextureSlot MaterialTable::slot(int index, int texcoord, const tinygltf::ExtensionMap& extensions,
                                       TextureMember texture) {
    scene::TextureSlot slot;
    if (index < 0) return slot;
    if (const Value* transform = extension(extensions, "KHR_texture_transform")) {
        slot.uv_transform = uv_transform(*transform);
        texcoord = whole_in(*transform, "texCoord", texcoord);
    }
    const std::optional<int> set = texcoord_set(texcoord);
    if (!set) {
        warnings_.add(
            fmt::format("a material reads three sets of texture coordinates, and two are supported: "
                        "TEXCOORD_{}, TEXCOORD_{} and TEXCOORD_{}",
                        *sets_[0], *sets_[1], texcoord),
            "the material is shown without the texture of the third");
        return {};
    }
    slot.texcoord = *set;
    slot.texture = textures_.texture(index, scene::texture_inputs[scene::texture_slot(texture)].color_space);
    return slot;
}

std::optional<int> MaterialTable::texcoord_set(int n) {
    for (int set = 0; set < 2; ++set)
        if (sets_[static_cast<std::size_t>(set)] == n) return set;
    const int usual = n == 1 ? 1 : 0;
    for (const int set : {usual, 1 - usual}) {
        auto& taken = sets_[static_cast<std::size_t>(set)];
        if (taken) continue;
        taken = n;
        return set;
    }
    return std::nullopt;
}

void MaterialTable::read_texture(const Value& from, const char* key, TextureMember texture,
                                 scene::Material& to) {
    if (!from.Has(key)) return;
    const Value& info = from.Get(key);
    tinygltf::ExtensionMap extensions;
    if (info.Has("extensions"))
        for (const std::string& name : info.Get("extensions").Keys())
            extensions[name] = info.Get("extensions").Get(name);
    to.*texture = slot(whole_in(info, "index", -1), whole_in(info, "texCoord", 0), extensions, texture);
}

void MaterialTable::read_specular(const tinygltf::Material& from, scene::Material& to) {
    const Value* specular = extension(from.extensions, "KHR_materials_specular");
    if (!specular) return;
    to.specular = fraction(number_in(*specular, "specularFactor", 1.0), "specularFactor", from.name);
    to.specular_color = not_negative(document_, three_in(*specular, "specularColorFactor", vec3(1.0f)),
                                     "specularColorFactor", from.name);
    read_texture(*specular, "specularTexture", &scene::Material::specular_texture, to);
    read_texture(*specular, "specularColorTexture", &scene::Material::specular_color_texture, to);
}

void MaterialTable::read_emission(const tinygltf::Material& from, scene::Material& to) {
    const Value* strength = extension(from.extensions, "KHR_materials_emissive_strength");
    const auto factor = static_cast<float>(strength ? number_in(*strength, "emissiveStrength", 1.0) : 1.0);
    const auto& e = from.emissiveFactor;
    to.emission =
        not_negative(document_, vec3(e[0], e[1], e[2]) * factor, "emissive factor times strength", from.name);
    const Value* stated = steradian_in(from.extras);
    if (!stated) return;
    const std::string title = fmt::format("material {}", in_quotes(from.name));
    bool is_flux = false;
    const Conversion conversion = [&](scene::Quantity quantity, double value) {
        is_flux = quantity == scene::Quantity::flux;
        const bool is_determined = is_flux || quantity == scene::Quantity::radiance;
        return is_determined ? std::optional(value) : std::nullopt;
    };
    const vec3 stated_emission =
        emitted(document_, parse_emission(document_, stated, title), glm::dvec3(to.emission), conversion,
                title, "state what a material emits in cd/m^2 or lm, or in W/(m^2 sr) or W");
    if (!is_flux) {
        to.emission = stated_emission;
        return;
    }
    fluxes_[static_cast<int>(materials_.size())] = {glm::dvec3(stated_emission), title};
    to.emission = vec3(0.0f);
}

void MaterialTable::share_fluxes(scene::Scene& scene) const {
    std::map<int, double> area; // by material
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (!fluxes_.contains(mesh.material)) continue;
        const glm::dmat4 world(instance.world_from_object);
        const auto corner = [&](std::size_t i) {
            return glm::dvec3(world * glm::dvec4(mesh.positions[mesh.indices[i]], 1.0f));
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
            area[mesh.material] +=
                0.5 * glm::length(glm::cross(corner(i + 1) - corner(i), corner(i + 2) - corner(i)));
    }
    for (const auto& [number, flux] : fluxes_) {
        scene::Material& material = scene.materials[static_cast<std::size_t>(number)];
        const double emitting = area[number] * (material.is_double_sided ? 2.0 : 1.0);
        if (!(emitting > 0.0))
            document_.fail(fmt::format("{} states a flux, and no surface with an area has it", flux.title),
                           "give it a surface, or state its radiance in cd/m^2");
        material.emission = as_floats(document_, flux.Phi / (glm::pi<double>() * emitting), flux.title);
    }
}

void MaterialTable::read_metallic_roughness(const tinygltf::Material& from, scene::Material& to) {
    const auto& pbr = from.pbrMetallicRoughness;
    for (int i = 0; i < 4; ++i)
        to.base_color[i] =
            fraction(pbr.baseColorFactor[static_cast<std::size_t>(i)], "baseColorFactor", from.name);
    to.metallic = fraction(pbr.metallicFactor, "metallicFactor", from.name);
    to.roughness = fraction(pbr.roughnessFactor, "roughnessFactor", from.name);
    const auto read = [&](TextureMember texture, const auto& info) {
        to.*texture = slot(info.index, info.texCoord, info.extensions, texture);
    };
    read(&scene::Material::base_color_texture, pbr.baseColorTexture);
    read(&scene::Material::metallic_roughness_texture, pbr.metallicRoughnessTexture);
    if (const Value* ior = extension(from.extensions, "KHR_materials_ior"))
        to.ior = static_cast<float>(number_in(*ior, "ior", 1.5));
    if (to.ior != 0.0f && !(to.ior >= 1.0f && std::isfinite(to.ior)))
        document_.fail(fmt::format("material {}: ior is {}", in_quotes(from.name), to.ior),
                       "give 0, or 1 and more");
    read_specular(from, to);
}

// A dielectric of infinite ior, whose F0 is the specular colour, as KHR_materials_ior has it; the glossiness
// and what F0 takes from the diffuse colour are shaders/surface/'s.
void MaterialTable::read_specular_glossiness(const tinygltf::Material& from, const Value& stated,
                                             scene::Material& to) {
    to.is_specular_glossiness = true;
    to.metallic = 0.0f;
    to.ior = 0.0f;
    const vec3 specular = three_in(stated, "specularFactor", vec3(1.0f));
    for (int i = 0; i < 4; ++i) {
        const double diffuse =
            stated.Has("diffuseFactor") ? stated.Get("diffuseFactor").Get(i).GetNumberAsDouble() : 1.0;
        to.base_color[i] = fraction(diffuse, "diffuseFactor", from.name);
        if (i < 3) to.specular_color[i] = fraction(double{specular[i]}, "specularFactor", from.name);
    }
    to.roughness = 1.0f - fraction(number_in(stated, "glossinessFactor", 1.0), "glossinessFactor", from.name);
    read_texture(stated, "diffuseTexture", &scene::Material::base_color_texture, to);
    read_texture(stated, "specularGlossinessTexture", &scene::Material::specular_color_texture, to);
}

scene::Material MaterialTable::read(const tinygltf::Material& from, int number) {
    scene::Material to;
    to.name = from.name;
    sets_ = {};
    to.is_unlit = extension(from.extensions, "KHR_materials_unlit") != nullptr;
    // Where a material has both, the extension asks to be preferred to metallic-roughness; unlit prefers the
    // latter.
    const Value* glossy = extension(from.extensions, "KHR_materials_pbrSpecularGlossiness");
    const Value* stated = steradian_in(from.extras);
    const bool names_brdf = stated && stated->Has("brdf");
    const bool is_core = !glossy || to.is_unlit || names_brdf;
    if (is_core)
        read_metallic_roughness(from, to);
    else
        read_specular_glossiness(from, *glossy, to);
    const auto read = [&](TextureMember texture, const auto& info) {
        to.*texture = slot(info.index, info.texCoord, info.extensions, texture);
    };
    read(&scene::Material::normal_texture, from.normalTexture);
    to.normal_scale =
        clamped(from.normalTexture.scale, -steepest_map, steepest_map, "normalTexture/scale", from.name);
    read(&scene::Material::emission_texture, from.emissiveTexture);

    // Where the map is lost, nothing of it is emitted: a surface that glows all over would light the scene.
    const bool has_map = from.emissiveTexture.index >= 0
                         || document_.is_lost(fmt::format("/materials/{}/emissiveTexture", number));
    if (to.emission_texture.is_present() || !has_map) read_emission(from, to);
    read_anisotropy(from, to);
    read_clearcoat(from, to);
    read_sheen(from, to);
    read_iridescence(from, to);
    read_transmission(from, to);
    read_volume(from, to);
    read_diffuse_transmission(from, to);
    read_brdf(from, to);

    to.alpha_mode = alpha_mode_of(from.alphaMode);
    to.alpha_cutoff = static_cast<float>(from.alphaCutoff);
    to.is_double_sided = from.doubleSided;
    for (int set = 0; set < 2; ++set)
        to.texcoord_sets[static_cast<std::size_t>(set)] = sets_[static_cast<std::size_t>(set)].value_or(set);
    return to;
}

} // namespace sr::gltf
