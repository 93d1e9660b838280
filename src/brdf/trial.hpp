#pragma once
// Asks the shaders of shaders/trial/ about a specimen. Directions are unit, in a frame where z is the normal
// and x the tangent.
#include "brdf/specimen.hpp"
#include "render/gpu/shader_evaluator.hpp"

#include <memory>
#include <span>

namespace sr::brdf {

struct Pair {
    vec3 wi{0.0f};
    vec3 wo{0.0f};
};

/// A direction and a density there, or over another density.
struct Weighted {
    vec3 wi{0.0f};
    float weight = 0.0f;
};

class Trial {
public:
    /// Compiles at the first question of each kind. Needs a current context for as long as it lives.
    explicit Trial(const Specimen& specimen);

    /// Other parameters of the same features (features_of), so that nothing is compiled anew.
    void change(const scene::Material& material);
    const Specimen& specimen() const { return specimen_; }

    /// f_r [1/sr] for each pair. @throws gl::ShaderError, also from the others
    std::vector<vec3> values(std::span<const Pair> pairs);

    /// ∫ f_r cosθ_i dω_i for each wo, from `count` directions each.
    std::vector<glm::dvec3> albedos(std::span<const vec3> wo, int count);

    /// Directions above the horizon and p / q there: their mean over `count` integrates p. Those with
    /// wi.z < 0 are to be left out.
    std::vector<Weighted> densities(vec3 wo, int count);

    /// What the BRDF's own sampling makes of each u, and p there.
    std::vector<Weighted> samples(vec3 wo, std::span<const vec2> u);

private:
    std::vector<vec4> asked(std::unique_ptr<render::ShaderEvaluator>& table, const char* shader,
                            std::span<const render::Row> rows);

    Specimen specimen_;
    std::vector<glsl::Root> path_;
    gl::Texture ltc_texture_;
    std::vector<gl::Texture> measured_;
    std::unique_ptr<render::ShaderEvaluator> value_, reflected_, density_, sampled_;
};

} // namespace sr::brdf
