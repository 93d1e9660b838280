#include "support/glsl_table.hpp"

#include "gl/program.hpp"
#include "glsl/root.hpp"
#include "render/film.hpp"
#include "support/gl.hpp"

namespace sr::testing {
namespace {

constexpr int columns = 256;

gl::Program table_program(const std::string& preamble, const std::string& body, const glsl::Files& overlay) {
    const std::string fragment =
        "#version 410 core\n" + preamble
        + "\nuniform samplerBuffer rows;\nuniform int row_count;\nout vec4 result;\n"
          "vec4 f(vec4 a, vec4 b, vec4 c) {\n"
        + body
        + "\n}\nvoid main() {\n    int row = int(gl_FragCoord.y) * 256 + int(gl_FragCoord.x);\n"
          "    if (row >= row_count) { result = vec4(0.0); return; }\n"
          "    result = f(texelFetch(rows, 3 * row), texelFetch(rows, 3 * row + 1),\n"
          "               texelFetch(rows, 3 * row + 2));\n}\n";
    const std::array path{glsl::Root::memory("table", {{"table.frag", fragment}}),
                          glsl::Root::memory("overlay", overlay), glsl::embedded()};
    return {"table", glsl::expand(path, "fullscreen.vert"), glsl::expand(path, "table.frag")};
}

} // namespace

std::vector<vec4> evaluate(const std::string& preamble, const std::string& body, std::span<const Row> rows,
                           const render::GpuScene* scene, const glsl::Files& overlay) {
    context();
    const gl::Program program = table_program(preamble, body, overlay);
    const int count = static_cast<int>(rows.size());
    const int height = (count + columns - 1) / columns;
    const render::Target target("table", columns, height, false);

    const gl::Buffer buffer("rows");
    glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(rows.size_bytes()), rows.data(), GL_STATIC_DRAW);
    const gl::Texture table(GL_TEXTURE_BUFFER, "rows");
    table.bind(0);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer.id());

    const gl::VertexArray no_vertices("no vertices");
    glBindVertexArray(no_vertices.id());
    target.bind();
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    program.use();
    program.bind_texture("rows", 0);
    program.bind_texture("light_table", render::light_table_unit);
    program.bind_texture("emission_texels", render::emission_texels_unit);
    program.bind_texture("ltc_table", render::ltc_table_unit);
    if (scene) scene->bind_lights();
    glProgramUniform1i(program.id(), program.uniform("row_count"), count);
    glDrawArrays(GL_TRIANGLES, 0, 3);

    const image::Image image = target.read();
    std::vector<vec4> results;
    for (int i = 0; i < count; ++i) {
        const auto texel = image.at(i % columns, height - 1 - i / columns); // row 0 of GL is the image's last
        results.emplace_back(texel[0], texel[1], texel[2], texel[3]);
    }
    return results;
}

} // namespace sr::testing
