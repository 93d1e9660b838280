#pragma once
// The material of a surface, the images that it reads, and the tables of its BRDF models and its textures.
// Plain data, linear unless stated otherwise.
#include "core/math.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sr::scene {

/// A decoded picture: `width * height` RGBA texels, first row on top (glTF: uv (0,0) is its upper left
/// corner). The values are as stored in the file; whether they are sRGB-encoded is the Texture's business.
struct TextureImage {
    std::string name;
    int width = 0;
    int height = 0;
    /// 4 * width * height values, of 8 or (16-bit PNGs) 16 bits.
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>> texels;
};

enum class Wrap { repeat, mirrored_repeat, clamp_to_edge };

/// The texel of a row of `size` that index `i` stands for, within the row or beyond it.
int wrapped(int i, int size, Wrap wrap);

/// Returns the position of uv among the centres of width × height texels, in texels. Coordinates that are no
/// numbers, or so far out (2^24 texels) that the next float is a texel away, count as 0. Keep in sync with
/// shaders/base/texel_wrap.glsl.
inline vec2 texel_place(vec2 uv, int width, int height) {
    constexpr float farthest = 1.6e7f;
    const vec2 at = uv * vec2(width, height);
    const bool is_near = std::abs(at.x) < farthest && std::abs(at.y) < farthest;
    return (is_near ? at : vec2(0.0f)) - 0.5f;
}

enum class Filter { nearest, linear };
/// The mip levels that minification reads.
enum class Mipmap { none, nearest, linear };

struct Sampler {
    Wrap wrap_u = Wrap::repeat;
    Wrap wrap_v = Wrap::repeat;
    Filter magnification = Filter::linear;
    Filter minification = Filter::linear;
    Mipmap mipmap = Mipmap::linear;

    bool operator==(const Sampler&) const = default;
};

enum class ColorSpace { linear, srgb };

/// An image as a material reads it.
struct Texture {
    int image = 0; // index into Scene::images
    Sampler sampler;
    ColorSpace color_space = ColorSpace::linear;

    bool operator==(const Texture&) const = default;
};

/// A material's reference to a texture; absent where `texture` is negative.
struct TextureSlot {
    int texture = -1;        // index into Scene::textures
    int texcoord = 0;        // which of the mesh's texture coordinate sets, 0 or 1
    mat3 uv_transform{1.0f}; // KHR_texture_transform: uv' = (uv_transform * (uv, 1)).xy

    bool is_present() const { return texture >= 0; }
};

enum class AlphaMode { opaque, mask, blend };

/// The BRDF of a surface: glTF's own, or one that extras.steradian names. Each is a row of brdf_models.
enum class Model {
    metallic_roughness,
    lambert,
    oren_nayar,
    mirror,
    phong,
    blinn_phong,
    ggx,
    conductor,
    merl
};

/// A conductor's index of refraction n + ik for red, green and blue. Source: conductor.hpp.
struct ComplexIor {
    vec3 n{1.0f};
    vec3 k{0.0f};
};

/// glTF 2.0 metallic-roughness with its KHR_materials_ extensions, and what extras.steradian adds.
/// Each factor multiplies its texture, if there is one.
struct Material {
    std::string name;

    vec4 base_color{1.0f}; // linear, alpha in w
    TextureSlot base_color_texture;
    float metallic = 1.0f;  // texture: blue channel
    float roughness = 1.0f; // texture: green channel; alpha = roughness² is formed in shaders/surface/
    TextureSlot metallic_roughness_texture;
    float normal_scale = 1.0f;
    TextureSlot normal_texture; // tangent space, +Y up

    vec3 emission{0.0f}; // L_e [cd/m²]: emissiveFactor times KHR_materials_emissive_strength
    TextureSlot emission_texture;

    float ior = 1.5f;      // KHR_materials_ior; 0 stands for infinity (F0 = 1), as the extension says
    float specular = 1.0f; // KHR_materials_specular; texture: alpha channel
    TextureSlot specular_texture;
    vec3 specular_color{1.0f};
    TextureSlot specular_color_texture;

    float anisotropy = 0.0f;          // KHR_materials_anisotropy: strength, 0 to 1; texture: blue channel
    float anisotropy_rotation = 0.0f; // from the tangent towards the bitangent [rad]
    TextureSlot anisotropy_texture;   // red, green: a direction in the tangent plane, -1 to 1

    float clearcoat = 0.0f; // KHR_materials_clearcoat: weight; texture: red channel
    TextureSlot clearcoat_texture;
    float clearcoat_roughness = 0.0f; // texture: green channel
    TextureSlot clearcoat_roughness_texture;
    float clearcoat_normal_scale = 1.0f;
    TextureSlot clearcoat_normal_texture;

    vec3 sheen_color{0.0f}; // KHR_materials_sheen
    TextureSlot sheen_color_texture;
    float sheen_roughness = 0.0f; // texture: alpha channel
    TextureSlot sheen_roughness_texture;

    float iridescence = 0.0f; // KHR_materials_iridescence: weight; texture: red channel
    TextureSlot iridescence_texture;
    float film_ior = 1.3f;
    float min_film_thickness = 100.0f; // [nm], where the texture's green channel is 0
    float max_film_thickness = 400.0f; // [nm], where it is 1, or there is none
    TextureSlot film_thickness_texture;

    float transmission = 0.0f; // KHR_materials_transmission: share of the base; texture: red channel
    TextureSlot transmission_texture;
    float thickness = 0.0f; // KHR_materials_volume [m], in the mesh's space; texture: green channel
    TextureSlot thickness_texture;
    float attenuation_distance = std::numeric_limits<float>::infinity(); // [m], in world space
    vec3 attenuation_color{1.0f}; // what white light becomes over that distance

    float diffuse_transmission = 0.0f; // KHR_materials_diffuse_transmission; texture: alpha channel
    TextureSlot diffuse_transmission_texture;
    vec3 diffuse_transmission_color{1.0f};
    TextureSlot diffuse_transmission_color_texture;

    Model model = Model::metallic_roughness;
    float roughness_across = -1.0f; // ggx, conductor: across the tangent; negative: `roughness`
    float exponent = 32.0f;         // phong, blinn_phong
    ComplexIor conductor;           // conductor
    int measured = -1;              // merl: index into Scene::measured

    /// KHR_materials_pbrSpecularGlossiness: the base colour is the diffuse one, `specular_color` is F0 with
    /// the glossiness (1 - roughness) in its texture's alpha, and F0 takes its largest channel from the
    /// diffuse.
    bool is_specular_glossiness = false;

    /// The n of the file's TEXCOORD_n, for the meshes' first and second set of texture coordinates.
    std::array<int, 2> texcoord_sets{0, 1};

    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f;
    bool is_double_sided = false;
    bool is_unlit = false; // KHR_materials_unlit: L_o is the base colour [cd/m²], no light touches it

    /// True if the GGX lobe is wider along one direction; then meshes need tangents.
    bool is_anisotropic() const {
        return model == Model::metallic_roughness ? anisotropy > 0.0f
                                                  : roughness_across >= 0.0f && roughness_across != roughness;
    }
    bool has_sheen() const { return sheen_color.x > 0.0f || sheen_color.y > 0.0f || sheen_color.z > 0.0f; }
    /// True if light passes straight through, as through glass. Metal lets none through.
    bool is_transmissive() const {
        return model == Model::metallic_roughness && !is_specular_glossiness && !is_unlit
               && transmission > 0.0f && (metallic < 1.0f || metallic_roughness_texture.is_present());
    }
    /// True if light from behind is scattered to the front, as by a leaf.
    bool transmits_diffusely() const {
        return model == Model::metallic_roughness && !is_specular_glossiness && !is_unlit
               && diffuse_transmission > 0.0f;
    }
    bool is_emissive() const { return emission.x > 0.0f || emission.y > 0.0f || emission.z > 0.0f; }
};

/// The reflectance of a dielectric at normal incidence, ((ior - 1) / (ior + 1))²; 0 stands for an infinite
/// ior (KHR_materials_ior).
float F0_from_ior(float ior);

/// Describes the BRDF: "metallic_roughness, clearcoat, sheen".
std::string describe(const Material& material);

/// Returns the least alpha that alphaMode MASK shows. The cutoff itself is opaque (glTF 2.0, section 3.9.4),
/// also where an alpha that equals it was rounded: most where texels are half floats, by 2^-11 of the value.
/// That is less than an eighth of a step of 8 bits.
float min_opaque_alpha(const Material& material);

/// σ of KHR_materials_volume [1/m]: what is left of light after d metres is exp(-σ d).
vec3 attenuation_coefficient(const Material& material);

/// A BRDF, and what the renderer may do with it. Its shader is shaders/brdf/models/NAME.glsl.
struct BrdfModel {
    std::string_view name;        // as extras.steradian has it
    bool is_analytic = false;     // the analytic estimator integrates it, if it is isotropic and not layered
    bool has_microfacets = false; // GGX, which loses energy and can be compensated for it
    bool is_delta = false;        // f_r has no values
    /// The plugin of Mitsuba's own that evaluates it within our `steradian_framed`; empty: our
    /// `steradian_NAME` does.
    std::string_view mitsuba_plugin{};
};

/// All of them, in the order of Model.
inline constexpr std::array brdf_models{
    BrdfModel{.name = "metallic_roughness", .is_analytic = true, .has_microfacets = true},
    BrdfModel{.name = "lambert", .is_analytic = true, .mitsuba_plugin = "diffuse"},
    BrdfModel{.name = "oren_nayar", .is_analytic = true},
    BrdfModel{.name = "mirror", .is_delta = true, .mitsuba_plugin = "conductor"},
    BrdfModel{.name = "phong"},
    BrdfModel{.name = "blinn_phong"},
    BrdfModel{.name = "ggx", .is_analytic = true, .has_microfacets = true},
    BrdfModel{.name = "conductor", .is_analytic = true, .has_microfacets = true},
    BrdfModel{.name = "merl"}};

/// A parameter that some BRDFs have beside glTF's base colour and roughness. It is a property of
/// extras.steradian, and an option of `steradian brdf`.
struct BrdfParameter {
    std::string_view key;
    std::string_view meaning;    // with its unit
    std::array<Model, 2> models; // that have it; one is named twice
    std::variant<float Material::*, vec3 Material::*, ComplexIor Material::*, int Material::*> member;
    float min = 0.0f;
    float max = 1.0f;
    std::optional<float> fallback{}; // of files that do not state it
    bool is_alternative = false;     // another way to state the parameter before it

    constexpr bool is_of(Model model) const { return models[0] == model || models[1] == model; }
};

/// All of them. Those of one model are its `model_parameters` in GLSL, in this order (render/gpu/blocks.hpp).
inline constexpr std::array brdf_parameters{
    BrdfParameter{.key = "roughness_across",
                  .meaning = "the roughness across the tangent, where glTF's is the one along it",
                  .models = {Model::ggx, Model::conductor},
                  .member = &Material::roughness_across},
    BrdfParameter{.key = "exponent",
                  .meaning = "the power of the cosine that their lobe is",
                  .models = {Model::phong, Model::blinn_phong},
                  .member = &Material::exponent,
                  .max = 1e6f,
                  .fallback = 32.0f},
    BrdfParameter{.key = "specular_color",
                  .meaning =
                      "what their lobe reflects at normal incidence; with the base colour no more than 1",
                  .models = {Model::phong, Model::blinn_phong},
                  .member = &Material::specular_color,
                  .fallback = 0.04f},
    BrdfParameter{.key = "metal",
                  .meaning = "one whose index of refraction is known",
                  .models = {Model::conductor, Model::conductor},
                  .member = &Material::conductor},
    BrdfParameter{.key = "complex_ior",
                  .meaning = "n + ik for red, green and blue",
                  .models = {Model::conductor, Model::conductor},
                  .member = &Material::conductor,
                  .is_alternative = true},
    BrdfParameter{.key = "ior_spectrum",
                  .meaning = "triples [wavelength in nm, n, k], ascending, linear between",
                  .models = {Model::conductor, Model::conductor},
                  .member = &Material::conductor,
                  .is_alternative = true},
    BrdfParameter{.key = "file",
                  .meaning = "a measured BRDF in the MERL database's binary format, beside the glTF",
                  .models = {Model::merl, Model::merl},
                  .member = &Material::measured}};

static_assert(brdf_models.size() == static_cast<std::size_t>(Model::merl) + 1);

constexpr const BrdfModel& brdf_model(Model model) { return brdf_models[static_cast<std::size_t>(model)]; }
constexpr std::string_view name_of(Model model) { return brdf_model(model).name; }
std::optional<Model> model_named(std::string_view name);

/// Names the models that have the parameter, between commas or `between`: "ggx, conductor".
std::string models_with(const BrdfParameter& parameter, std::string_view between = ", ");

/// A texture that a material can have.
struct TextureInput {
    std::string_view
        name; // "base_color": GLSL has base_color_slot, base_color_texture and has_base_color_texture
    TextureSlot Material::*member;
    ColorSpace color_space;    // of its texels
    std::string_view channels; // of its texels that shading reads, in the order "rgba"

    constexpr bool is_in_alpha() const { return channels == "a"; }
};

/// All of them. A slot is a place in this table, here and in GLSL (shaders/interface/material.glsl).
inline constexpr std::array texture_inputs{
    TextureInput{"base_color", &Material::base_color_texture, ColorSpace::srgb, "rgba"},
    TextureInput{"metallic_roughness", &Material::metallic_roughness_texture, ColorSpace::linear, "gb"},
    TextureInput{"normal", &Material::normal_texture, ColorSpace::linear, "rgb"},
    TextureInput{"emission", &Material::emission_texture, ColorSpace::srgb, "rgb"},
    TextureInput{"specular", &Material::specular_texture, ColorSpace::linear, "a"},
    TextureInput{"specular_color", &Material::specular_color_texture, ColorSpace::srgb, "rgba"},
    TextureInput{"anisotropy", &Material::anisotropy_texture, ColorSpace::linear, "rgb"},
    TextureInput{"clearcoat", &Material::clearcoat_texture, ColorSpace::linear, "r"},
    TextureInput{"clearcoat_roughness", &Material::clearcoat_roughness_texture, ColorSpace::linear, "g"},
    TextureInput{"clearcoat_normal", &Material::clearcoat_normal_texture, ColorSpace::linear, "rgb"},
    TextureInput{"sheen_color", &Material::sheen_color_texture, ColorSpace::srgb, "rgb"},
    TextureInput{"sheen_roughness", &Material::sheen_roughness_texture, ColorSpace::linear, "a"},
    TextureInput{"iridescence", &Material::iridescence_texture, ColorSpace::linear, "r"},
    TextureInput{"film_thickness", &Material::film_thickness_texture, ColorSpace::linear, "g"},
    TextureInput{"transmission", &Material::transmission_texture, ColorSpace::linear, "r"},
    TextureInput{"thickness", &Material::thickness_texture, ColorSpace::linear, "g"},
    TextureInput{"diffuse_transmission", &Material::diffuse_transmission_texture, ColorSpace::linear, "a"},
    TextureInput{"diffuse_transmission_color", &Material::diffuse_transmission_color_texture,
                 ColorSpace::srgb, "rgb"}};
inline constexpr unsigned slot_count = static_cast<unsigned>(texture_inputs.size());

/// The slot of a member, as in texture_slot(&Material::normal_texture).
constexpr std::size_t texture_slot(TextureSlot Material::*member) {
    std::size_t slot = 0;
    while (texture_inputs[slot].member != member) ++slot;
    return slot;
}

/// A property of a surface that few materials have, such as a coat. It costs shading nothing where it is
/// absent.
enum class Layer { anisotropy, iridescence, sheen, clearcoat, transmission, diffuse_transmission };

/// A number or a colour that a layer has beside its textures.
struct LayerParameter {
    std::string_view key; // of the export to Mitsuba
    std::variant<std::monostate, float Material::*, vec3 Material::*> member{};
};

struct MaterialLayer {
    std::string_view name; // as `info` shows it
    std::string_view flag; // the constant of shaders/interface/features.glsl
    bool (*is_of)(const Material&);
    std::array<TextureSlot Material::*, 3> textures; // that shading reads for this layer alone; may be null
    std::array<LayerParameter, 4> parameters{};      // empty: Mitsuba has no such layer
    bool needs_tangents = false;
    bool needs_surface = false;    // lines and points do not have it
    bool has_analytic_form = true; // the analytic estimator integrates surfaces that have it
};

/// All of them, in the order of Layer.
inline constexpr std::array material_layers{
    MaterialLayer{.name = "anisotropic",
                  .flag = "has_anisotropy",
                  .is_of = [](const Material& m) { return m.is_anisotropic(); },
                  .textures = {&Material::anisotropy_texture},
                  .parameters = {{{"anisotropy", &Material::anisotropy},
                                  {"anisotropy_rotation", &Material::anisotropy_rotation}}},
                  .needs_tangents = true,
                  .has_analytic_form = false},
    MaterialLayer{.name = "thin film",
                  .flag = "has_iridescence",
                  .is_of = [](const Material& m) { return m.iridescence > 0.0f; },
                  .textures = {&Material::iridescence_texture, &Material::film_thickness_texture},
                  .parameters = {{{"iridescence", &Material::iridescence},
                                  {"film_ior", &Material::film_ior},
                                  {"min_film_thickness", &Material::min_film_thickness},
                                  {"max_film_thickness", &Material::max_film_thickness}}}},
    MaterialLayer{.name = "sheen",
                  .flag = "has_sheen",
                  .is_of = [](const Material& m) { return m.has_sheen(); },
                  .textures = {&Material::sheen_color_texture, &Material::sheen_roughness_texture},
                  .parameters = {{{"sheen_color", &Material::sheen_color},
                                  {"sheen_roughness", &Material::sheen_roughness}}},
                  .has_analytic_form = false},
    MaterialLayer{.name = "clearcoat",
                  .flag = "has_clearcoat",
                  .is_of = [](const Material& m) { return m.clearcoat > 0.0f; },
                  .textures = {&Material::clearcoat_texture, &Material::clearcoat_roughness_texture,
                               &Material::clearcoat_normal_texture},
                  .parameters = {{{"clearcoat", &Material::clearcoat},
                                  {"clearcoat_roughness", &Material::clearcoat_roughness},
                                  {"clearcoat_normal_scale", &Material::clearcoat_normal_scale}}},
                  .has_analytic_form = false},
    MaterialLayer{.name = "transmission (straight through: not refracted, not blurred)",
                  .flag = "is_transmissive",
                  .is_of = [](const Material& m) { return m.is_transmissive(); },
                  .textures = {&Material::transmission_texture, &Material::thickness_texture},
                  .needs_surface = true},
    MaterialLayer{
        .name = "diffuse transmission",
        .flag = "has_diffuse_transmission",
        .is_of = [](const Material& m) { return m.transmits_diffusely(); },
        .textures = {&Material::diffuse_transmission_texture, &Material::diffuse_transmission_color_texture},
        .needs_surface = true,
        .has_analytic_form = false}};
inline constexpr std::size_t layer_count = material_layers.size();
static_assert(layer_count == static_cast<std::size_t>(Layer::diffuse_transmission) + 1);

/// True if shading reads the tangents of meshes of this material.
bool needs_tangents(const Material& material);

/// The texture coordinate set that tangents follow: the normal map's, or that of what else needs them.
int tangent_texcoord(const Material& material);

} // namespace sr::scene
