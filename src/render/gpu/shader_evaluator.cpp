#include "render/gpu/shader_evaluator.hpp"

#include "glsl/source.hpp"
#include "render/gpu/blocks.hpp"
#include "render/gpu/gpu_texture.hpp"

#include <algorithm>

namespace sr::render {
namespace {

constexpr int columns = 256;
constexpr GLuint rows_unit = environment_texels_unit + 1;

gl::Program compiled(std::span<const glsl::Root> path, const std::string& fragment, gl::TrialCompiler* trial,
                     std::vector<glsl::Loop>& loops) {
    const glsl::Source vertex_source = glsl::expand(path, "fullscreen.vert");
    const glsl::Source fragment_source = glsl::expand(path, fragment);
    if (trial) trial->try_out(vertex_source, fragment_source);
    loops = fragment_source.loops;
    return {fragment, vertex_source, fragment_source};
}

} // namespace

ShaderEvaluator::ShaderEvaluator(std::span<const glsl::Root> path, const std::string& fragment,
                                 gl::TrialCompiler* trial)
    : program_(compiled(path, fragment, trial, loops_)) {
    program_.bind_texture("rows", rows_unit);
    connect(program_);
}

std::vector<vec4> ShaderEvaluator::evaluate(std::span<const Row> rows) const {
    const std::size_t most = std::min<std::size_t>(BufferTexture::max_texels() / 3, 1 << 20);
    std::vector<vec4> answers;
    answers.reserve(rows.size());
    for (std::size_t first = 0; first < rows.size(); first += most)
        append(rows.subspan(first, std::min(most, rows.size() - first)), answers);
    if (!answers.empty()) glsl::require_ended_loops({&answers[0].x, 4 * answers.size()}, loops_);
    return answers;
}

void ShaderEvaluator::append(std::span<const Row> rows, std::vector<vec4>& answers) const {
    const int count = static_cast<int>(rows.size());
    const int height = (count + columns - 1) / columns;
    glActiveTexture(GL_TEXTURE0
                    + rows_unit); // what is made here must not take the place of the caller's textures
    const RenderTarget target("table", columns, height, Depths::none);
    BufferTexture table("the rows of a table", GL_RGBA32F);
    table.upload(std::vector<Row>(rows.begin(), rows.end()), "evaluate fewer rows");

    const gl::VertexArray no_vertices("no vertices");
    glBindVertexArray(no_vertices.id());
    target.bind();
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    program_.use();
    table.bind(rows_unit);
    glProgramUniform1i(program_.id(), program_.uniform("row_count"), count);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    const image::Image image = target.read();
    for (int i = 0; i < count; ++i) {
        const auto texel = image.at(i % columns, height - 1 - i / columns); // row 0 of GL is the image's last
        answers.emplace_back(texel[0], texel[1], texel[2], texel[3]);
    }
}

} // namespace sr::render
