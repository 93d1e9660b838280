#include "brdf/evaluator.hpp"

#include "core/error.hpp"
#include "render/gpu/blocks.hpp"
#include "render/gpu/gpu_texture.hpp"
#include "render/gpu/ltc_table.hpp"

namespace sr::brdf {
namespace {

using render::Row;

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
    const render::MaterialBlock block = render::pack_material(tested_.material, tested_.measured);
    glBindBufferBase(GL_UNIFORM_BUFFER, render::material_block, material_.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
    ltc_texture_.bind(render::ltc_table_unit);
    glBindSampler(render::ltc_table_unit, 0);
    if (tested_.material.measured >= 0) {
        measured_[static_cast<std::size_t>(tested_.material.measured)].bind(render::measured_unit);
        glBindSampler(render::measured_unit, 0);
    }
    return table->evaluate(rows);
}

std::vector<vec3> BrdfEvaluator::evaluate(std::span<const DirectionPair> pairs) {
    std::vector<Row> rows;
    for (const DirectionPair& pair : pairs) rows.push_back({vec4(pair.wi, 0.0f), vec4(pair.wo, 0.0f)});
    std::vector<vec3> values;
    for (const vec4 answer : evaluate(value_, "brdf_eval/value.frag", rows)) values.emplace_back(answer);
    return values;
}

std::vector<glm::dvec3> BrdfEvaluator::albedos(std::span<const vec3> wo, int count) {
    std::vector<Row> rows;
    for (const vec3 w : wo) {
        const std::vector<Row> more = numbered_rows(w, count);
        rows.insert(rows.end(), more.begin(), more.end());
    }
    const std::vector<vec4> answers = evaluate(reflected_, "brdf_eval/reflected.frag", rows);
    std::vector<glm::dvec3> albedos(wo.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i < answers.size(); ++i)
        albedos[i / static_cast<std::size_t>(count)] +=
            glm::dvec3(vec3(answers[i])) / static_cast<double>(count);
    return albedos;
}

std::vector<WeightedDirection> BrdfEvaluator::densities(vec3 wo, int count) {
    std::vector<WeightedDirection> densities;
    for (const vec4 answer : evaluate(density_, "brdf_eval/density.frag", numbered_rows(wo, count)))
        densities.push_back({vec3(answer), answer.w});
    return densities;
}

std::vector<WeightedDirection> BrdfEvaluator::samples(vec3 wo, std::span<const vec2> u) {
    std::vector<Row> rows;
    for (const vec2 point : u) rows.push_back({vec4(wo, 0.0f), vec4(point, 0.0f, 0.0f)});
    std::vector<WeightedDirection> samples;
    for (const vec4 answer : evaluate(sampled_, "brdf_eval/sampled.frag", rows))
        samples.push_back({vec3(answer), answer.w});
    return samples;
}

} // namespace sr::brdf
