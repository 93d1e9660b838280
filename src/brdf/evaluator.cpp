#include "brdf/evaluator.hpp"

#include "core/error.hpp"
#include "render/gpu/blocks.hpp"
#include "render/gpu/gpu_texture.hpp"
#include "render/gpu/ltc_table.hpp"

#include <algorithm>
#include <array>

namespace sr::brdf {
namespace {

using render::Row;
using scene::Model;

constexpr float min_alpha = 1e-4f; // shaders/surface/at_fragment.glsl
float alpha_of(float roughness) { return std::max(roughness * roughness, min_alpha); }

/// The GGX width by which the shaders sample directions: the model's own, or that of a GGX lobe of the same
/// height.
float lobe_width(const BrdfUnderTest& tested) {
    const scene::Material& m = tested.material;
    if (m.model == Model::phong || m.model == Model::blinn_phong)
        return std::clamp(std::sqrt(2.0f / (m.exponent + 2.0f)), min_alpha, 1.0f);
    if (m.model == Model::merl) return tested.measured[static_cast<std::size_t>(m.measured)].alpha;
    return alpha_of(m.roughness);
}

/// The parameters of shaders/trial/subject.glsl, which makes a Surface of them as
/// shaders/surface/at_fragment.glsl does of a Material.
std::array<vec4, 12> parameters_of(const BrdfUnderTest& tested) {
    const scene::Material& m = tested.material;
    const float r = (m.ior - 1.0f) / (m.ior + 1.0f);
    const vec3 F0 = glm::min((m.ior == 0.0f ? 1.0f : r * r) * m.specular_color, vec3(1.0f));
    const float alpha = lobe_width(tested);
    const bool is_stated = m.roughness_across >= 0.0f;
    const vec2 alphas{is_stated ? alpha : glm::mix(alpha, 1.0f, m.anisotropy * m.anisotropy),
                      is_stated ? alpha_of(m.roughness_across) : alpha};
    return {
        vec4(vec3(m.base_color), m.metallic),
        vec4(F0, m.specular),
        vec4(alpha, m.roughness, alphas),
        vec4(m.clearcoat, alpha_of(m.clearcoat > 0.0f ? m.clearcoat_roughness : 0.15f), m.exponent, alpha),
        vec4(m.sheen_color, alpha_of(m.sheen_roughness)),
        vec4(m.iridescence, m.film_ior, m.largest_film_thickness, 0.0f),
        vec4(m.conductor.n, 0.0f),
        vec4(m.conductor.k, 0.0f),
        vec4(m.specular_color, 0.0f),
        vec4(m.anisotropy_rotation, 0.0f, 0.0f, 0.0f),
        vec4(m.diffuse_transmission_color, m.diffuse_transmission),
        vec4(m.transmission, 0.0f, 0.0f, 0.0f)};
}

std::vector<Row> numbered_rows(vec3 wo, int count) {
    std::vector<Row> rows;
    for (int i = 0; i < count; ++i) rows.push_back({vec4(wo, static_cast<float>(i))});
    return rows;
}

} // namespace

BrdfEvaluator::BrdfEvaluator(const BrdfUnderTest& tested)
    : tested_(tested), path_(shader_path(tested)), ltc_texture_(render::upload_ltc_table()) {
    for (const scene::MeasuredBrdf& measured : tested.measured) measured_.push_back(render::upload(measured));
}

void BrdfEvaluator::change(const scene::Material& material) {
    const render::Features before = features_of(tested_);
    tested_.material = material;
    require(features_of(tested_) == before, "the new material has the features of the old one");
}

std::vector<vec4> BrdfEvaluator::evaluate(std::unique_ptr<render::ShaderEvaluator>& table, const char* shader,
                                          std::span<const Row> rows) {
    if (!table) table = std::make_unique<render::ShaderEvaluator>(path_, shader, tested_.trial.get());
    const auto parameters = parameters_of(tested_);
    const gl::Program& program = table->program();
    glProgramUniform4fv(program.id(), program.uniform("parameters"), static_cast<GLsizei>(parameters.size()),
                        &parameters[0].x);
    ltc_texture_.bind(render::ltc_table_unit);
    glBindSampler(render::ltc_table_unit, 0);
    if (tested_.material.measured >= 0) {
        measured_[static_cast<std::size_t>(tested_.material.measured)].bind(render::measured_unit);
        glBindSampler(render::measured_unit, 0);
    }
    return table->evaluate(rows);
}

std::vector<vec3> BrdfEvaluator::values(std::span<const DirectionPair> pairs) {
    std::vector<Row> rows;
    for (const DirectionPair& pair : pairs) rows.push_back({vec4(pair.wi, 0.0f), vec4(pair.wo, 0.0f)});
    std::vector<vec3> values;
    for (const vec4 answer : evaluate(value_, "trial/value.frag", rows)) values.emplace_back(answer);
    return values;
}

std::vector<glm::dvec3> BrdfEvaluator::albedos(std::span<const vec3> wo, int count) {
    std::vector<Row> rows;
    for (const vec3 w : wo) {
        const std::vector<Row> more = numbered_rows(w, count);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    const std::vector<vec4> answers = evaluate(reflected_, "trial/reflected.frag", rows);
    std::vector<glm::dvec3> albedos(wo.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < answers.size(); ++i)
        albedos[i / static_cast<std::size_t>(count)] +=
            glm::dvec3(vec3(answers[i])) / static_cast<double>(count);
    return albedos;
}

std::vector<WeightedDirection> BrdfEvaluator::densities(vec3 wo, int count) {
    std::vector<WeightedDirection> densities;
    for (const vec4 answer : evaluate(density_, "trial/density.frag", numbered_rows(wo, count)))
        densities.push_back({vec3(answer), answer.w});
    return densities;
}

std::vector<WeightedDirection> BrdfEvaluator::samples(vec3 wo, std::span<const vec2> u) {
    std::vector<Row> rows;
    for (const vec2 point : u) rows.push_back({vec4(wo, 0.0f), vec4(point, 0.0f, 0.0f)});
    std::vector<WeightedDirection> samples;
    for (const vec4 answer : evaluate(sampled_, "trial/sampled.frag", rows))
        samples.push_back({vec3(answer), answer.w});
    return samples;
}

} // namespace sr::brdf
