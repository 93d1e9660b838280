#pragma once
// Pictures of a BRDF: a polar plot of its lobe, and a lit sphere.
#include "brdf/evaluator.hpp"
#include "image/image.hpp"

#include <string>

namespace sr::brdf {

/// Draws f_r cosθ_i in the plane of incidence as SVG: a curve for wo at 0°, 30°, 60° and 80°, each scaled to
/// its largest value, which is printed with the albedo. @throws gl::ShaderError
std::string draw_polar_plot(BrdfEvaluator& evaluator, const std::string& title);

/// Renders `size`² pixels [cd/m²] of a sphere under a softbox (from the left), a strip (from the right) and a
/// point light, with its tangents along the parallels. Needs a current context. @throws gl::ShaderError
image::Image render_sphere(const BrdfUnderTest& tested, int size, int samples);

} // namespace sr::brdf
