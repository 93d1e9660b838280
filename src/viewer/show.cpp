#include "viewer/show.hpp"

#include <chrono>

namespace sr::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

render::GpuScene uploaded(const LoadedScene& scene, render::Visibility visibility, double& seconds) {
    const auto begin = Clock::now();
    render::GpuScene gpu(scene.stage.scene, scene.stage.lights, visibility);
    glFinish();
    seconds = seconds_since(begin);
    return gpu;
}

} // namespace

Show::Show(LoadedScene scene, const Options& options, const scene::Camera& camera, int width, int height)
    : scene_(std::move(scene)),
      gpu_(uploaded(scene_, options.visibility, upload_seconds_)),
      lighting_(scene_, options.hide_emitters) {
    make_picture(options, camera, width, height);
}

void Show::make_picture(const Options& options, const scene::Camera& camera, int width, int height) {
    const auto begin = Clock::now();
    picture_ = std::make_unique<Picture>(gpu_, camera, render_options(options, width, height), options.stop);
    compile_seconds_ = seconds_since(begin);
}

void Show::set_visibility(Options& options, render::Visibility visibility, const scene::Camera& camera,
                          int width, int height) {
    const render::Visibility before = options.visibility;
    gpu_ = uploaded(scene_, visibility, upload_seconds_);
    options.visibility = visibility;
    try {
        make_picture(options, camera, width, height);
    } catch (...) {
        options.visibility = before;
        gpu_ = uploaded(scene_, before, upload_seconds_);
        make_picture(options, camera, width, height);
        throw;
    }
}

void Show::relight(bool casters_change) {
    lighting_.apply(scene_);
    gpu_.relight(scene_.stage.scene, scene_.stage.lights, scene_.base.meshes, casters_change);
    picture_->relit();
}

render::RenderOptions render_options(const Options& options, int width, int height) {
    render::RenderOptions rendering = options.rendering;
    rendering.width = width;
    rendering.height = height;
    rendering.samples = options.stop.samples;
    rendering.knows_error = options.stop.asks_for_error();
    rendering.shader_path.clear();
    for (const std::string& folder : options.shaders)
        rendering.shader_path.push_back(glsl::Root::folder(folder));
    rendering.shader_path.push_back(glsl::embedded());
    return rendering;
}

} // namespace sr::viewer
