#pragma once
// Evaluates GLSL over a table of inputs, on the very code that renders: a law is tested where it applies.
#include "core/math.hpp"
#include "glsl/root.hpp"
#include "render/glsl_table.hpp"
#include "render/gpu_scene.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace sr::testing {

/// One row of inputs, which the GLSL reads as vec4 a, b, c.
using render::Row;

/// Runs `body`, the body of `vec4 f(vec4 a, vec4 b, vec4 c)`, for each row, after `preamble` (includes,
/// functions). Draws into an RGBA32F target; nothing is clamped. With a `scene`, its lights are in the light
/// table. Files of `overlay` replace the shaders' own.
std::vector<vec4> evaluate(const std::string& preamble, const std::string& body, std::span<const Row> rows,
                           const render::GpuScene* scene = nullptr, const glsl::Files& overlay = {});

} // namespace sr::testing
