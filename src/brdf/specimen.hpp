#pragma once
// A BRDF to be looked at by itself: one of ours with parameters, or a file of the user's own.
#include "gl/trial_compiler.hpp"
#include "glsl/root.hpp"
#include "render/gpu/features.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sr::brdf {

/// GLSL that declares `vec3 f_r(Surface x, vec3 wi, vec3 wo)`, and maybe how it is sampled.
struct UserShader {
    std::string text;
    std::string place; // what errors call it
    bool has_sampling = false;
};

/// @throws Error if the file cannot be read or does not declare f_r, or declares only a part of its sampling
/// (has_peak, sample_f_r, p_f_r)
UserShader read_user_shader(const std::filesystem::path& file);

struct Specimen {
    scene::Material material;
    std::vector<scene::MeasuredBrdf> measured; // what material.measured counts in
    bool has_energy_compensation = false;
    std::optional<UserShader> user;
    std::shared_ptr<gl::TrialCompiler> trial = nullptr; // of the user's shader; null: it is compiled at once

    /// Whether f_r is a delta, which has no values to look at.
    bool is_delta() const { return !user && material.model == scene::Model::mirror; }
    /// Whether the model is reciprocal by its definition.
    bool is_reciprocal() const { return user || !(material.clearcoat > 0.0f); }
    /// Whether its definition keeps it from reflecting more than arrives: glTF's coated dielectric does not
    /// (shaders/README.md).
    bool keeps_energy() const {
        return user || material.model != scene::Model::metallic_roughness || material.metallic == 1.0f
               || material.specular == 0.0f;
    }
    bool has_sampling() const { return !is_delta() && (!user || user->has_sampling); }
};

/// What a program for this specimen takes; materials of one model that have the same layers have the same.
render::Features features_of(const Specimen& specimen);

/// The roots that its shaders come from, most particular first: the user's, and all of ours.
std::vector<glsl::Root> overlay_path(const Specimen& specimen);

/// The same with ours specialised to features_of(specimen), as the renderer does it for a material.
std::vector<glsl::Root> shader_path(const Specimen& specimen);

} // namespace sr::brdf
