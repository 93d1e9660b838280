#pragma once
// Provenance of a picture, as attributes of its file.
#include "gl/context.hpp"
#include "image/image.hpp"
#include "render/adaptive/convergence.hpp"
#include "render/renderer.hpp"
#include "render/visibility/visibility_backend.hpp"

#include <string>
#include <vector>

namespace sr::render {

const char* name_of(Estimator estimator);

/// Samples of a picture's pixels.
struct SampleCounts {
    double mean = 0.0;
    int min = 0;
    int max = 0;
};
SampleCounts counted(const std::vector<int>& samples);

struct Provenance {
    std::string unit;   // of the pixels
    std::string camera; // its name, or the view as --camera takes it
    Estimator estimator = Estimator::sampled;
    int analytic_points = default_analytic_points; // of the analytic estimator
    Visibility visibility = Visibility::ray;
    SampleCounts samples;
    std::uint32_t seed = 0;
    std::optional<double> error;         // √relMSE, where it is known
    std::optional<double> error_target;  // of the stop rule
    std::optional<double> seconds;       // time of the animation; absent: the rest pose
    std::optional<StoppedBy> stopped_by; // absent: the rendering goes on
    std::string view;                    // name of the variable; empty: radiance
    bool is_denoised = false;
};

/// Returns "steradian:version", "steradian:estimator" and so on.
std::vector<image::Attribute> attributes_of(const Provenance& provenance, const gl::ContextInfo& gl);

} // namespace sr::render
