#pragma once
// Evaluates GLSL over a table of inputs, on the very code that renders.
#include "core/math.hpp"
#include "gl/program.hpp"
#include "gl/trial_compiler.hpp"
#include "glsl/root.hpp"
#include "glsl/untrusted.hpp"
#include "render/film.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace sr::render {

/// A row of inputs: three texels of the buffer texture `rows`.
using Row = std::array<vec4, 3>;

/// A fragment shader that is evaluated once per row. It reads `uniform samplerBuffer rows`; the texels of a
/// pixel start at 3 (256 gl_FragCoord.y + gl_FragCoord.x). It draws the rows below `uniform int row_count`
/// and writes one vec4 each (shaders/brdf_eval/table.glsl does all that).
class ShaderEvaluator {
public:
    /// Compiles `fragment` of the shader path with fullscreen.vert. Needs a current context.
    /// `trial` tries it before; null: it is compiled at once. @throws ShaderError, Error
    ShaderEvaluator(std::span<const glsl::Root> path, const std::string& fragment,
                    gl::TrialCompiler* trial = nullptr);

    /// The answers in the order of the rows, none of them clamped. @throws LoopError if a loop of untrusted
    /// code was stopped. Textures other than `rows` are the caller's to bind, at the units of blocks.hpp.
    std::vector<vec4> evaluate(std::span<const Row> rows) const;

    const gl::Program& program() const { return program_; }

private:
    void append(std::span<const Row> rows, std::vector<vec4>& answers) const;

    std::vector<glsl::Loop> loops_; // of untrusted code
    gl::Program program_;
};

} // namespace sr::render
