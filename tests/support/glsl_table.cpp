#include "support/glsl_table.hpp"

#include "support/gl.hpp"

namespace sr::testing {

std::vector<vec4> evaluate(const std::string& preamble, const std::string& body, std::span<const Row> rows,
                           const render::GpuScene* scene, const glsl::Files& overlay) {
    context();
    const std::string fragment = "#version 410 core\n" + preamble
                                 + "\n#include \"brdf_eval/table.glsl\"\n"
                                   "vec4 f(vec4 a, vec4 b, vec4 c) {\n"
                                 + body
                                 + "\n}\nvoid main() {\n"
                                   "    answer = row_number() < row_count ? f(row_part(0), row_part(1), "
                                   "row_part(2)) : vec4(0.0);\n}\n";
    const std::array path{glsl::Root::memory("table", {{"table.frag", fragment}}),
                          glsl::Root::memory("overlay", overlay), glsl::embedded()};
    const render::ShaderEvaluator table(path, "table.frag");
    if (scene) scene->bind_lights();
    return table.evaluate(rows);
}

} // namespace sr::testing
