#pragma once
// A BRDF where people look for it: on a ball.
#include "brdf/specimen.hpp"
#include "image/image.hpp"

namespace sr::brdf {

/// A picture [cd/m²] of `size`² pixels of a ball under a softbox (from the left), a strip (from the right)
/// and a point light, with its tangents along the parallels. Needs a current context. @throws gl::ShaderError
image::Image lit_sphere(const Specimen& specimen, int size, int samples);

} // namespace sr::brdf
