#include "brdf/parameters.hpp"

#include "core/file.hpp"
#include "scene/conductor.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <span>

namespace sr::brdf {
namespace {

using scene::Material;
using scene::Model;

constexpr float no_limit = std::numeric_limits<float>::max();

std::vector<TestedParameter> all_parameters() {
    std::vector<TestedParameter> all{
        {"base_color", "ρ; F0 of ggx; tint of conductor and merl", &Material::base_color},
        {"roughness", "of gltf, ggx, conductor, oren_nayar", &Material::roughness},
        {"metallic", "of gltf", &Material::metallic},
        {"specular", "of gltf: weight of the dielectric's layer", &Material::specular},
        {"ior", "of gltf", &Material::ior, 1.0f, 100.0f},
        {"specular_color", "of gltf; of phong, blinn_phong: what their lobe reflects at normal incidence",
         &Material::specular_color},
        {"anisotropy", "of gltf", &Material::anisotropy},
        {"rotation", "of the anisotropy [rad]", &Material::anisotropy_rotation, -no_limit, no_limit},
        {"clearcoat", "of gltf", &Material::clearcoat},
        {"clearcoat_roughness", "of gltf", &Material::clearcoat_roughness},
        {"sheen_color", "of gltf", &Material::sheen_color},
        {"sheen_roughness", "of gltf", &Material::sheen_roughness},
        {"iridescence", "of gltf: weight of a thin film", &Material::iridescence},
        {"film_ior", "of the thin film", &Material::film_ior, 1.0f, 10.0f},
        {"film_thickness", "of the thin film [nm]", &Material::max_film_thickness, 0.0f, no_limit}};
    for (const scene::BrdfParameter& row : scene::brdf_parameters) {
        const std::string key(row.key);
        if (std::ranges::find(all, key, &TestedParameter::key) != all.end()) continue; // glTF's own
        const std::string help = fmt::format("of {}: {}", scene::models_with(row), row.meaning);
        if (const auto* number = std::get_if<float Material::*>(&row.member))
            all.push_back({key, help, *number, row.min, row.max, row.fallback.has_value()});
        else if (const auto* color = std::get_if<vec3 Material::*>(&row.member))
            all.push_back({key, help, *color});
    }
    return all;
}

} // namespace

const std::vector<TestedParameter>& parameters() {
    static const std::vector<TestedParameter> all = all_parameters();
    return all;
}

void set(Material& material, const ParameterMember& member, vec3 value) {
    if (const auto* number = std::get_if<float Material::*>(&member)) material.*(*number) = value.x;
    if (const auto* color = std::get_if<vec3 Material::*>(&member)) material.*(*color) = value;
    if (const auto* color = std::get_if<vec4 Material::*>(&member)) material.*(*color) = vec4(value, 1.0f);
}

std::optional<BrdfUnderTest> brdf_named(const std::string& name, gl::Backend backend) {
    BrdfUnderTest tested;
    tested.material.base_color = vec4(1.0f);
    tested.material.roughness = 0.5f;
    const auto model = name == "gltf" ? Model::metallic_roughness : scene::model_named(name);
    if (name.ends_with(".glsl") || name.ends_with(".frag")) {
        tested.user = read_user_shader(name);
        tested.trial = std::make_shared<gl::TrialCompiler>(backend);
    } else if (name.ends_with(".binary")) {
        tested.material.model = Model::merl;
        tested.material.measured = 0;
        const std::vector<std::uint8_t> bytes = read_file(name, name);
        tested.measured.push_back(scene::read_merl(std::as_bytes(std::span(bytes)), name));
    } else if (model && *model != Model::merl) {
        tested.material.model = *model;
        if (*model == Model::conductor) set_metal(tested, "gold");
    } else {
        return std::nullopt;
    }
    return tested;
}

std::vector<std::string_view> builtin_names() {
    std::vector<std::string_view> names{"gltf"};
    for (const scene::BrdfModel& model : std::span(scene::brdf_models).subspan(1))
        if (model.name != scene::name_of(Model::merl)) names.push_back(model.name);
    return names;
}

bool set_metal(BrdfUnderTest& tested, std::string_view metal) {
    const auto spectrum = scene::measured_metal(metal);
    if (spectrum) tested.material.conductor = scene::fit_ior(*spectrum);
    return spectrum.has_value();
}

} // namespace sr::brdf
