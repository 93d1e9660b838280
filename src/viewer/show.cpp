#include "viewer/show.hpp"

#include "core/error.hpp"

#include <chrono>
#include <exception>

namespace sr::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

render::GpuScene uploaded(const LoadedScene& scene, const Options& options, double& seconds) {
    const auto begin = Clock::now();
    render::GpuScene gpu(scene.stage.scene, scene.stage.lights, options.visibility,
                         options.has_energy_compensation);
    glFinish();
    seconds = seconds_since(begin);
    return gpu;
}

} // namespace

Show::Show(LoadedScene scene, const Options& options, const scene::Camera& camera, int width, int height)
    : scene_(std::move(scene)),
      gpu_(uploaded(scene_, options, upload_seconds_)),
      lighting_(scene_, options.hide_emitters) {
    make_picture(options, camera, width, height);
}

void Show::make_picture(const Options& options, const scene::Camera& camera, int width, int height) {
    const auto begin = Clock::now();
    picture_ = std::make_unique<Picture>(gpu_, camera, render_options(options, width, height), options.stop);
    compile_seconds_ = seconds_since(begin);
}

void Show::resize(int width, int height) {
    picture_->resize(width, height);
    if (reference_) reference_->resize(width, height);
}

void Show::move(const scene::Camera& camera) {
    picture_->move(camera);
    if (reference_) reference_->move(camera);
}

void Show::advance_reference(const Options& options, const scene::Camera& camera, int width, int height) {
    if (!reference_ || reference_estimator_ != options.rendering.estimator) {
        Options theirs = options;
        theirs.shows_reference = true;
        reference_ =
            std::make_unique<Picture>(gpu_, camera, render_options(theirs, width, height), options.stop);
        reference_estimator_ = options.rendering.estimator;
    }
    reference_->advance();
}

void Show::set_visibility(Options& options, render::Visibility visibility, const scene::Camera& camera,
                          int width, int height) {
    const render::Visibility before = options.visibility;
    options.visibility = visibility;
    reference_.reset();
    try {
        gpu_ = uploaded(scene_, options, upload_seconds_);
        make_picture(options, camera, width, height);
    } catch (...) {
        options.visibility = before;
        gpu_ = uploaded(scene_, options, upload_seconds_);
        make_picture(options, camera, width, height);
        throw;
    }
}

void Show::relight(bool casters_change) {
    lighting_.apply(scene_);
    gpu_.relight(scene_.stage.scene, scene_.stage.lights, scene_.base.meshes, casters_change);
    picture_->relit();
    if (reference_) reference_->relit();
}

void Show::pose(const gltf::Moment& moment) {
    const gltf::Moment before = scene_.moment;
    std::exception_ptr failure;
    try {
        viewer::pose(scene_, moment);
    } catch (const Error&) {
        failure = std::current_exception();
        viewer::pose(scene_, before);
    }
    lighting_.rebase(scene_);
    lighting_.apply(scene_);
    const bool deforms = scene_.contents.skins > 0 || scene_.contents.morph_targets > 0;
    gpu_.relight(scene_.stage.scene, scene_.stage.lights, deforms ? 0 : scene_.base.meshes, true);
    picture_->relit();
    if (reference_) reference_->relit();
    if (failure) std::rethrow_exception(failure);
}

void Show::take_edits(LightEditor lighting) {
    lighting_ = std::move(lighting);
    lighting_.rebase(scene_);
    if (lighting_.is_changed()) relight(true);
}

render::RenderOptions render_options(const Options& options, int width, int height) {
    render::RenderOptions rendering = options.rendering;
    rendering.width = width;
    rendering.height = height;
    rendering.samples = options.stop.samples;
    rendering.knows_error = options.stop.asks_for_error();
    if (options.shows_reference) {
        rendering.shader_path = options.reference_path;
        return rendering;
    }
    rendering.shader_path.clear();
    for (const std::string& folder : options.shaders)
        rendering.shader_path.push_back(glsl::Root::folder(folder));
    rendering.shader_path.push_back(glsl::embedded());
    return rendering;
}

} // namespace sr::viewer
