#pragma once
// A lobe as people draw it.
#include "brdf/trial.hpp"

#include <string>

namespace sr::brdf {

/// An SVG of f_r cosθ_i in the plane of incidence, a curve for wo at 0°, 30°, 60° and 80°, each scaled to its
/// largest value, which stands beside it with the albedo. `title` is the picture's. @throws gl::ShaderError
std::string polar_plot(Trial& trial, const std::string& title);

} // namespace sr::brdf
