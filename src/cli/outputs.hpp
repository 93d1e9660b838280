#pragma once
// From a film to files that say what they hold.
#include "cli/render_options.hpp"
#include "cli/stopping.hpp"
#include "gl/context.hpp"

namespace sr::cli {

/// The samples of a picture's pixels.
struct SampleCounts {
    double mean = 0.0;
    int least = 0;
    int most = 0;
};
SampleCounts counted(const std::vector<int>& samples);

/// What a rendering leaves.
struct Picture {
    image::Image film;                  // R, G, B, A
    std::optional<image::Image> layers; // the film and whatever else was asked for
    SampleCounts samples;
    Stop stop;
};

/// The unit of the film, or of the view that stands for it.
std::string unit_of(const RenderCommand& command, scene::UnitSystem units);

/// Says in the images' attributes how they were made and why they ended.
void describe(Picture& picture, const RenderCommand& command, const scene::RenderScene& stage,
              const gl::ContextInfo& gl);

/// Says on stderr why a picture is black, and if it has holes.
void remark_on(const image::Image& film, const RenderCommand& command, const scene::RenderScene& stage);

/// Whether the file's format has room for more than one picture (.exr).
bool holds_layers(const std::string& output);

/// Writes the picture in the form that each file's extension asks for, its layers where there is room for
/// them.
/// @return the EV100 in use, if any was. @throws Error
std::optional<float> write_outputs(const Picture& picture, const RenderCommand& command);

} // namespace sr::cli
