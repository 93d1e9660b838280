#pragma once
// A BRDF under test: one of ours with parameters, a measured one, or a user's shader.
#include "gl/trial_compiler.hpp"
#include "glsl/root.hpp"
#include "render/gpu/features.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sr::brdf {

/// GLSL that declares `vec3 f_r(Surface x, vec3 wi, vec3 wo)`, and optionally its sampling.
struct UserShader {
    std::string text;
    std::string place; // what errors call it
    bool has_sampling = false;
};

/// Reads a user's shader. @throws Error if the file cannot be read or does not declare f_r, or declares only
/// a part of its sampling (has_peak, sample_f_r, pdf_f_r)
UserShader read_user_shader(const std::filesystem::path& file);

struct BrdfUnderTest {
    scene::Material material;
    std::vector<scene::MeasuredBrdf> measured; // indexed by material.measured
    bool has_energy_compensation = false;
    std::optional<UserShader> user;
    std::shared_ptr<gl::TrialCompiler> trial = nullptr; // of the user's shader; null: compiles directly

    /// True if f_r is a delta, which has no values.
    bool is_delta() const { return !user && scene::brdf_model(material.model).is_delta; }
    /// True if the model is reciprocal by its definition.
    bool is_reciprocal() const { return user || !(material.clearcoat > 0.0f); }
    /// True if the model conserves energy by its definition: glTF's coated dielectric does not
    /// (shaders/README.md).
    bool keeps_energy() const {
        return user || material.model != scene::Model::metallic_roughness || material.metallic == 1.0f
               || material.specular == 0.0f;
    }
    bool has_sampling() const { return !is_delta() && (!user || user->has_sampling); }
};

/// The features of its shader program; equal for materials of one model with the same layers.
render::Features features_of(const BrdfUnderTest& tested);

/// The roots of its shaders, most specific first: the user's, then all of ours.
std::vector<glsl::Root> overlay_path(const BrdfUnderTest& tested);

/// The same with ours specialised to features_of(tested), as the renderer does it for a material.
std::vector<glsl::Root> shader_path(const BrdfUnderTest& tested);

} // namespace sr::brdf
