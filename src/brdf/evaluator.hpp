#pragma once
// Evaluation of a BRDF by the shaders of shaders/brdf_eval/. Directions are unit vectors in a frame with the
// normal along z and the tangent along x.
#include "brdf/brdf_under_test.hpp"
#include "render/gpu/shader_evaluator.hpp"

#include <memory>
#include <span>

namespace sr::brdf {

struct DirectionPair {
    vec3 wi{0.0f};
    vec3 wo{0.0f};
};

/// A direction with a density, or with a ratio of two densities.
struct WeightedDirection {
    vec3 wi{0.0f};
    float weight = 0.0f;
};

class BrdfEvaluator {
public:
    /// Compiles each kind of shader when it is first used. Needs a current context during its lifetime.
    explicit BrdfEvaluator(const BrdfUnderTest& tested);

    /// Sets other parameters of the same features (features_of), so that nothing is compiled again.
    void change(const scene::Material& material);
    const BrdfUnderTest& tested() const { return tested_; }

    /// f_r [1/sr] for each pair. @throws gl::ShaderError, as do the others
    std::vector<vec3> evaluate(std::span<const DirectionPair> pairs);

    /// ∫ f_r cosθ_i dω_i for each wo, from `count` directions each.
    std::vector<glm::dvec3> albedos(std::span<const vec3> wo, int count);

    /// Directions above the horizon and p / q there: their mean over `count` integrates p. Leave out those
    /// with wi.z < 0.
    std::vector<WeightedDirection> densities(vec3 wo, int count);

    /// The direction that the BRDF's own sampling makes of each u, and p there.
    std::vector<WeightedDirection> samples(vec3 wo, std::span<const vec2> u);

private:
    std::vector<vec4> evaluate(std::unique_ptr<render::ShaderEvaluator>& table, const char* shader,
                               std::span<const render::Row> rows);

    BrdfUnderTest tested_;
    std::vector<glsl::Root> path_;
    gl::Texture ltc_texture_;
    std::vector<gl::Texture> measured_;
    gl::Buffer material_{"the material of a BRDF"};
    std::unique_ptr<render::ShaderEvaluator> value_, reflected_, density_, sampled_;
};

} // namespace sr::brdf
