#pragma once
// What every command that renders begins with: a context, and a scene set before a camera.
#include "cli/render_options.hpp"
#include "cli/summary.hpp"
#include "render/renderer.hpp"

#include <memory>

namespace sr::cli {

struct OpenScene {
    std::unique_ptr<gl::Context> context;
    scene::Stage stage;
    Size size;
};

/// Opens a context and loads the scene beside it; warnings and remarks go to stderr. @throws Error
OpenScene open_scene(const RenderCommand& command, PhaseTimes& times);

render::RenderOptions render_options(const RenderCommand& command, Size size);

} // namespace sr::cli
