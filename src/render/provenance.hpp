#pragma once
// How a picture was made, as attributes of its file.
#include "gl/context.hpp"
#include "image/image.hpp"
#include "render/renderer.hpp"
#include "render/visibility/visibility_backend.hpp"

#include <string>
#include <vector>

namespace sr::render {

const char* name_of(Estimator estimator);

/// What a file says of its picture, whoever writes it.
struct Provenance {
    std::string unit;   // of the pixels
    std::string camera; // its name, or the view as --camera takes it
    Estimator estimator = Estimator::sampled;
    int analytic_points = default_analytic_points; // of the analytic estimator
    Visibility visibility = Visibility::ray;
    int samples = 0; // the most that a pixel has
    std::uint32_t seed = 0;
    std::optional<double> error;   // √relMSE, where it is known
    std::optional<double> seconds; // the moment of the animation; absent: the rest pose
};

/// "steradian:version", "steradian:estimator" and so on.
std::vector<image::Attribute> attributes_of(const Provenance& provenance, const gl::ContextInfo& gl);

} // namespace sr::render
