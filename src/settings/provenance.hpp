#pragma once
// Provenance of a picture, as attributes of its file.
#include "gl/context.hpp"
#include "image/image.hpp"
#include "render/adaptive/convergence.hpp"
#include "settings/render_settings.hpp"

#include <optional>
#include <string>
#include <vector>

namespace sr::settings {

/// Samples of a picture's pixels.
struct SampleCounts {
    double mean = 0.0;
    int min = 0;
    int max = 0;
};
SampleCounts count_samples(const std::vector<int>& samples);

/// Result of a rendering.
struct RenderResult {
    std::string unit;   // of the pixels
    std::string camera; // its name, or the view as --camera takes it
    SampleCounts samples;
    std::optional<double> error;                 // √relMSE, where it is known
    std::optional<render::StoppedBy> stopped_by; // absent: the rendering goes on
    int light_choices = 0;                       // of a sample; 0: it visits all lights
};

/// Returns "steradian:version", "steradian:estimator" and so on: those of the outcome, and those of the table
/// of options.
std::vector<image::Attribute> attributes_of(const RenderSettings& settings, const RenderResult& outcome,
                                            const gl::ContextInfo& gl);

} // namespace sr::settings
