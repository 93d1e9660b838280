#include "gltf/read/material.hpp"

#include "gltf/warnings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <optional>

namespace sr::gltf {
namespace {

using TextureMember = scene::TextureSlot scene::Material::*;

/// The steepest that a normal map is made by its scale: beyond, only the direction of its slope is left.
constexpr double steepest_map = 1e6;

vec2 two_in(const json& object, std::string_view key, vec2 fallback) {
    const std::vector<double> two = numbers_in(object, key);
    return two.empty() ? fallback : vec2(two[0], two[1]);
}

/// The same angle [rad] within half a turn of 0, so that a float keeps its digits.
double within_a_turn(double angle) { return std::remainder(angle, 2.0 * glm::pi<double>()); }

// KHR_texture_transform: translation * rotation * scale. It turns from +u towards -v for a positive angle:
// counter-clockwise as seen on the image, whose v goes down. (The extension's example, "the lower left
// quadrant rotated clockwise by 90°", holds for this sign only.)
mat3 uv_transform(const json& transform) {
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

/// Reads one material of a file.
class MaterialReader {
public:
    MaterialReader(const Document& document, const json& from, MeasuredTable& measured,
                   TextureTable& textures, Warnings& warnings)
        : document_(document),
          from_(from),
          measured_(measured),
          textures_(textures),
          warnings_(warnings),
          title_(fmt::format("material {}", in_quotes(text_in(from, "name")))),
          stated_(steradian_in(from)) {
        to_.name = text_in(from, "name");
    }

    /// @throws Error if a factor makes no sense
    scene::Material read(int number) {
        to_.is_unlit = extension(from_, "KHR_materials_unlit") != nullptr;
        // Where a material has both, the extension asks to be preferred to metallic-roughness; unlit prefers
        // the latter.
        const json* glossy = extension(from_, "KHR_materials_pbrSpecularGlossiness");
        const bool names_brdf = stated_ && stated_->contains("brdf");
        const bool is_core = !glossy || to_.is_unlit || names_brdf;
        if (is_core)
            read_metallic_roughness();
        else
            read_specular_glossiness(*glossy);
        to_.normal_scale = read_normal_map(from_, "normalTexture", &scene::Material::normal_texture);
        read_texture(from_, "emissiveTexture", &scene::Material::emission_texture);

        // Where the map is lost, nothing of it is emitted: a surface that glows all over would light the
        // scene.
        const bool has_map = from_.contains("emissiveTexture")
                             || document_.is_lost(fmt::format("/materials/{}/emissiveTexture", number));
        if (to_.emission_texture.is_present() || !has_map) read_emission();
        read_anisotropy();
        read_clearcoat();
        read_sheen();
        read_iridescence();
        read_transmission();
        read_volume();
        read_diffuse_transmission();
        if (stated_) read_brdf(document_, *stated_, title_, measured_, warnings_, to_);

        to_.alpha_mode = alpha_mode_of(text_in(from_, "alphaMode"));
        to_.alpha_cutoff = static_cast<float>(number_in(from_, "alphaCutoff", 0.5));
        to_.is_double_sided = flag_in(from_, "doubleSided", false);
        for (int set = 0; set < 2; ++set)
            to_.texcoord_sets[static_cast<std::size_t>(set)] =
                sets_[static_cast<std::size_t>(set)].value_or(set);
        return to_;
    }

    /// The flux that the material states for all surfaces that have it, in the scene's units.
    const std::optional<glm::dvec3>& flux() const { return flux_; }

private:
    float clamped(double value, double least, double most, std::string_view factor) {
        return gltf::clamped(value, least, most, factor, title_, warnings_);
    }

    float fraction(double value, std::string_view factor) { return clamped(value, 0.0, 1.0, factor); }

    /// @throws Error unless all components are zero or more, and floats
    vec3 not_negative(vec3 value, std::string_view factor) {
        return within(document_, value, std::numeric_limits<float>::max(), factor, title_,
                      "give zero or more");
    }

    /// Returns the set of a mesh, 0 or 1, that is TEXCOORD_n for this material. It takes a free set if none
    /// is yet; absent if both are taken.
    std::optional<int> texcoord_set(int n) {
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

    /// Reads the textureInfo `key` of an object, if it is there.
    void read_texture(const json& object, const char* key, TextureMember texture) {
        const auto info = object.find(key);
        if (info == object.end()) return;
        scene::TextureSlot slot;
        int texcoord = integer_in(*info, "texCoord", 0);
        if (const json* transform = extension(*info, "KHR_texture_transform")) {
            slot.uv_transform = uv_transform(*transform);
            texcoord = integer_in(*transform, "texCoord", texcoord);
        }
        const std::optional<int> set = texcoord_set(texcoord);
        if (!set)
            return warnings_.add(
                fmt::format("a material reads three sets of texture coordinates, and two are supported: "
                            "TEXCOORD_{}, TEXCOORD_{} and TEXCOORD_{}",
                            *sets_[0], *sets_[1], texcoord),
                "the material is shown without the texture of the third");
        slot.texcoord = *set;
        slot.texture = textures_.texture(info->at("index").get<int>(),
                                         scene::texture_inputs[scene::texture_slot(texture)].color_space);
        to_.*texture = slot;
    }

    /// The same, of a normal map. @return its scale
    float read_normal_map(const json& object, const char* key, TextureMember texture) {
        const auto info = object.find(key);
        if (info == object.end()) return 1.0f;
        read_texture(object, key, texture);
        return clamped(number_in(*info, "scale", 1.0), -steepest_map, steepest_map,
                       fmt::format("{}/scale", key));
    }

    vec3 color(const json& object, const char* factor) {
        vec3 color = not_negative(three_in(object, factor, vec3(1.0f)), factor);
        for (int i = 0; i < 3; ++i) color[i] = fraction(static_cast<double>(color[i]), factor);
        return color;
    }

    void read_base_color(const json& object, const char* factor) {
        const std::vector<double> color = numbers_in(object, factor);
        for (int i = 0; i < 4; ++i)
            to_.base_color[i] = fraction(color.empty() ? 1.0 : color[static_cast<std::size_t>(i)], factor);
    }

    void read_metallic_roughness() {
        static const json defaults = json::object();
        const auto found = from_.find("pbrMetallicRoughness");
        const json& pbr = found == from_.end() ? defaults : *found;
        read_base_color(pbr, "baseColorFactor");
        to_.metallic = fraction(number_in(pbr, "metallicFactor", 1.0), "metallicFactor");
        to_.roughness = fraction(number_in(pbr, "roughnessFactor", 1.0), "roughnessFactor");
        read_texture(pbr, "baseColorTexture", &scene::Material::base_color_texture);
        read_texture(pbr, "metallicRoughnessTexture", &scene::Material::metallic_roughness_texture);
        if (const json* ior = extension(from_, "KHR_materials_ior"))
            to_.ior = static_cast<float>(number_in(*ior, "ior", 1.5));
        if (to_.ior != 0.0f && !(to_.ior >= 1.0f && std::isfinite(to_.ior)))
            document_.fail(fmt::format("{}: ior is {}", title_, to_.ior), "give 0, or 1 and more");
        read_specular();
    }

    // A dielectric of infinite ior, whose F0 is the specular colour, as KHR_materials_ior has it; the
    // glossiness and what F0 takes from the diffuse colour are shaders/surface/'s.
    void read_specular_glossiness(const json& glossy) {
        to_.is_specular_glossiness = true;
        to_.metallic = 0.0f;
        to_.ior = 0.0f;
        const vec3 specular = three_in(glossy, "specularFactor", glm::dvec3(1.0));
        read_base_color(glossy, "diffuseFactor");
        for (int i = 0; i < 3; ++i) to_.specular_color[i] = fraction(double{specular[i]}, "specularFactor");
        to_.roughness = 1.0f - fraction(number_in(glossy, "glossinessFactor", 1.0), "glossinessFactor");
        read_texture(glossy, "diffuseTexture", &scene::Material::base_color_texture);
        read_texture(glossy, "specularGlossinessTexture", &scene::Material::specular_color_texture);
    }

    void read_specular() {
        const json* specular = extension(from_, "KHR_materials_specular");
        if (!specular) return;
        to_.specular = fraction(number_in(*specular, "specularFactor", 1.0), "specularFactor");
        to_.specular_color =
            not_negative(three_in(*specular, "specularColorFactor", vec3(1.0f)), "specularColorFactor");
        read_texture(*specular, "specularTexture", &scene::Material::specular_texture);
        read_texture(*specular, "specularColorTexture", &scene::Material::specular_color_texture);
    }

    void read_emission() {
        const json* strength = extension(from_, "KHR_materials_emissive_strength");
        const auto factor =
            static_cast<float>(strength ? number_in(*strength, "emissiveStrength", 1.0) : 1.0);
        const vec3 emission = three_in(from_, "emissiveFactor", glm::dvec3(0.0));
        to_.emission = not_negative(emission * factor, "emissive factor times strength");
        if (!stated_) return;
        bool is_flux = false;
        const Conversion conversion = [&](scene::Quantity quantity, double value) {
            is_flux = quantity == scene::Quantity::flux;
            const bool is_determined = is_flux || quantity == scene::Quantity::radiance;
            return is_determined ? std::optional(value) : std::nullopt;
        };
        const vec3 stated_emission =
            emitted(document_, parse_emission(document_, stated_, title_), glm::dvec3(to_.emission),
                    conversion, title_, "state what a material emits in cd/m^2 or lm, or in W/(m^2 sr) or W");
        if (!is_flux) {
            to_.emission = stated_emission;
            return;
        }
        flux_ = glm::dvec3(stated_emission);
        to_.emission = vec3(0.0f);
    }

    void read_anisotropy() {
        const json* anisotropy = extension(from_, "KHR_materials_anisotropy");
        if (!anisotropy) return;
        to_.anisotropy = fraction(number_in(*anisotropy, "anisotropyStrength", 0.0), "anisotropyStrength");
        to_.anisotropy_rotation =
            static_cast<float>(within_a_turn(number_in(*anisotropy, "anisotropyRotation", 0.0)));
        read_texture(*anisotropy, "anisotropyTexture", &scene::Material::anisotropy_texture);
    }

    void read_clearcoat() {
        const json* coat = extension(from_, "KHR_materials_clearcoat");
        if (!coat) return;
        to_.clearcoat = fraction(number_in(*coat, "clearcoatFactor", 0.0), "clearcoatFactor");
        to_.clearcoat_roughness =
            fraction(number_in(*coat, "clearcoatRoughnessFactor", 0.0), "clearcoatRoughnessFactor");
        read_texture(*coat, "clearcoatTexture", &scene::Material::clearcoat_texture);
        read_texture(*coat, "clearcoatRoughnessTexture", &scene::Material::clearcoat_roughness_texture);
        to_.clearcoat_normal_scale =
            read_normal_map(*coat, "clearcoatNormalTexture", &scene::Material::clearcoat_normal_texture);
    }

    void read_sheen() {
        const json* sheen = extension(from_, "KHR_materials_sheen");
        if (!sheen) return;
        const vec3 color = not_negative(three_in(*sheen, "sheenColorFactor", vec3(0.0f)), "sheenColorFactor");
        for (int i = 0; i < 3; ++i)
            to_.sheen_color[i] = fraction(static_cast<double>(color[i]), "sheenColorFactor");
        to_.sheen_roughness =
            fraction(number_in(*sheen, "sheenRoughnessFactor", 0.0), "sheenRoughnessFactor");
        read_texture(*sheen, "sheenColorTexture", &scene::Material::sheen_color_texture);
        read_texture(*sheen, "sheenRoughnessTexture", &scene::Material::sheen_roughness_texture);
    }

    void read_iridescence() {
        const json* film = extension(from_, "KHR_materials_iridescence");
        if (!film) return;
        to_.iridescence = fraction(number_in(*film, "iridescenceFactor", 0.0), "iridescenceFactor");
        to_.film_ior = static_cast<float>(number_in(*film, "iridescenceIor", 1.3));
        to_.min_film_thickness = static_cast<float>(number_in(*film, "iridescenceThicknessMinimum", 100.0));
        to_.max_film_thickness = static_cast<float>(number_in(*film, "iridescenceThicknessMaximum", 400.0));
        constexpr float max_ior = 1000.0f,
                        thickest = 1e9f; // [nm]: a metre is no film, and within, phases are floats
        if (!(to_.film_ior >= 1.0f && to_.film_ior <= max_ior))
            document_.fail(fmt::format("{}: iridescenceIor is {}", title_, to_.film_ior),
                           fmt::format("give 1 to {}", max_ior));
        for (const float thickness : {to_.min_film_thickness, to_.max_film_thickness})
            if (!(thickness >= 0.0f && thickness <= thickest))
                document_.fail(fmt::format("{}: its film is {} to {} nm thick", title_,
                                           to_.min_film_thickness, to_.max_film_thickness),
                               fmt::format("give 0 to {}", thickest));
        read_texture(*film, "iridescenceTexture", &scene::Material::iridescence_texture);
        read_texture(*film, "iridescenceThicknessTexture", &scene::Material::film_thickness_texture);
    }

    void read_transmission() {
        const json* transmission = extension(from_, "KHR_materials_transmission");
        if (!transmission) return;
        to_.transmission =
            fraction(number_in(*transmission, "transmissionFactor", 0.0), "transmissionFactor");
        read_texture(*transmission, "transmissionTexture", &scene::Material::transmission_texture);
    }

    void read_volume() {
        const json* volume = extension(from_, "KHR_materials_volume");
        if (!volume) return;
        to_.thickness = static_cast<float>(number_in(*volume, "thicknessFactor", 0.0));
        if (!(to_.thickness >= 0.0f))
            document_.fail(fmt::format("{}: thicknessFactor is {}", title_, to_.thickness),
                           "give zero or more");
        if (volume->contains("attenuationDistance")) {
            const auto distance = static_cast<float>(number_in(*volume, "attenuationDistance", 0.0));
            if (distance > 0.0f)
                to_.attenuation_distance = distance;
            else
                warnings_.add(fmt::format("{}: attenuationDistance is {}, not more than 0", title_, distance),
                              "nothing is attenuated");
        }
        to_.attenuation_color = color(*volume, "attenuationColor");
        read_texture(*volume, "thicknessTexture", &scene::Material::thickness_texture);
    }

    void read_diffuse_transmission() {
        const json* diffuse = extension(from_, "KHR_materials_diffuse_transmission");
        if (!diffuse) return;
        to_.diffuse_transmission =
            fraction(number_in(*diffuse, "diffuseTransmissionFactor", 0.0), "diffuseTransmissionFactor");
        to_.diffuse_transmission_color = color(*diffuse, "diffuseTransmissionColorFactor");
        read_texture(*diffuse, "diffuseTransmissionTexture", &scene::Material::diffuse_transmission_texture);
        read_texture(*diffuse, "diffuseTransmissionColorTexture",
                     &scene::Material::diffuse_transmission_color_texture);
    }

    const Document& document_;
    const json& from_;
    MeasuredTable& measured_;
    TextureTable& textures_;
    Warnings& warnings_;
    std::string title_;  // in messages
    const json* stated_; // extras.steradian, or null
    scene::Material to_;
    std::optional<glm::dvec3> flux_;
    std::array<std::optional<int>, 2> sets_; // of texture coordinates that the material reads
};

} // namespace

MaterialTable::MaterialTable(const Document& document, MeasuredTable& measured, Warnings& warnings)
    : document_(document), measured_(measured), warnings_(warnings), textures_(document, warnings) {}

int MaterialTable::material(int gltf_material) {
    const auto [entry, is_new] = number_of_.try_emplace(gltf_material, static_cast<int>(materials_.size()));
    const int number = entry->second;
    if (!is_new) return number;
    if (gltf_material < 0) {
        materials_.emplace_back();
        return number;
    }
    const json& from = document_.entry("materials", gltf_material);
    MaterialReader reader(document_, from, measured_, textures_, warnings_);
    materials_.push_back(reader.read(gltf_material));
    if (reader.flux())
        fluxes_[number] = {*reader.flux(), fmt::format("material {}", in_quotes(text_in(from, "name")))};
    return number;
}

std::vector<int> MaterialTable::numbers() const {
    std::vector<int> numbers(materials_.size(), -1);
    for (const auto& [in_file, here] : number_of_) numbers[static_cast<std::size_t>(here)] = in_file;
    return numbers;
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

} // namespace sr::gltf
