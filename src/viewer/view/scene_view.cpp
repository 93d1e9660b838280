#include "viewer/view/scene_view.hpp"

#include "core/error.hpp"
#include "scene/prepare.hpp"

#include <chrono>

namespace sr::viewer {
namespace {

using Clock = std::chrono::steady_clock;

double elapsed_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

render::GpuScene uploaded(const LoadedScene& loaded, const Options& options, double& seconds) {
    const auto begin = Clock::now();
    render::GpuScene gpu(loaded.stage.scene, loaded.stage.lights, options.visibility,
                         options.has_energy_compensation, options.texture_channels());
    glFinish();
    seconds = elapsed_since(begin);
    return gpu;
}

} // namespace

SceneView::SceneView(LoadedScene loaded, const Options& options, const scene::Camera& camera, int width,
                     int height)
    : loaded_(std::move(loaded)),
      gpu_(uploaded(loaded_, options, upload_seconds_)),
      lights_(loaded_, options.hide_emitters) {
    restart(options, camera, width, height);
    keep_shown();
}

void SceneView::restart(const Options& options, const scene::Camera& camera, int width, int height) {
    const auto begin = Clock::now();
    render_ = std::make_unique<ProgressiveRender>(gpu_, camera, render_options(options, width, height),
                                                  options.stop);
    compile_seconds_ = elapsed_since(begin);
}

void SceneView::resize(int width, int height) {
    render_->resize(width, height);
    if (reference_) reference_->resize(width, height);
}

scene::Camera SceneView::framing_camera(float aspect_ratio) {
    std::vector<scene::Instance>& instances = loaded_.stage.scene.instances;
    const auto own = instances.begin() + static_cast<std::ptrdiff_t>(loaded_.base.instances);
    const std::vector<scene::Instance> others(own, instances.end()); // surfaces of lights
    instances.erase(own, instances.end());
    const scene::Camera camera = scene::framing_camera(loaded_.stage.scene, aspect_ratio);
    instances.insert(instances.end(), others.begin(), others.end());
    return camera;
}

void SceneView::move(const scene::Camera& camera) {
    render_->move(camera);
    if (reference_) reference_->move(camera);
}

void SceneView::advance_reference(const Options& options, const scene::Camera& camera, int width,
                                  int height) {
    if (!reference_ || reference_estimator_ != options.rendering.estimator
        || reference_shader_ != options.rendering.shader) {
        Options theirs = options;
        theirs.shows_reference = true;
        reference_ = std::make_unique<ProgressiveRender>(gpu_, camera, render_options(theirs, width, height),
                                                         options.stop);
        reference_estimator_ = options.rendering.estimator;
        reference_shader_ = options.rendering.shader;
    }
    reference_->advance();
}

void SceneView::set_visibility(Options& options, render::Visibility visibility, const scene::Camera& camera,
                               int width, int height) {
    const render::Visibility before = options.visibility;
    options.visibility = visibility;
    reference_.reset();
    try {
        gpu_ = uploaded(loaded_, options, upload_seconds_);
        if (alone_) upload_lights(loaded_.base.meshes, false);
        restart(options, camera, width, height);
    } catch (...) {
        options.visibility = before;
        gpu_ = uploaded(loaded_, options, upload_seconds_);
        restart(options, camera, width, height);
        throw;
    }
}

void SceneView::relight(bool shadows_change) {
    try {
        show_edits(shadows_change);
    } catch (const Error&) {
        lights_.return_to(shown_);
        loaded_.hidden = shown_hidden_;
        show_edits(true);
        throw;
    }
    keep_shown();
}

void SceneView::show_edits(bool shadows_change) {
    lights_.apply(loaded_);
    upload_lights(loaded_.base.meshes, shadows_change);
    lights_changed();
}

/// Edits by which one entry lights the picture alone; absent if all do.
std::optional<LightEditor> SceneView::lights_alone() const {
    if (!alone_ || *alone_ >= lights_.entries().size()) return std::nullopt;
    LightEditor shown = lights_;
    for (std::size_t i = 0; i < lights_.entries().size(); ++i) shown.enable(i, i == *alone_);
    return shown;
}

void SceneView::keep_shown() {
    shown_ = lights_.state();
    shown_hidden_ = loaded_.hidden;
}

void SceneView::upload_lights(std::size_t first_mesh, bool shadows_change) {
    auto shown = lights_alone();
    if (shown) shown->apply(loaded_);
    gpu_.relight(loaded_.stage.scene, loaded_.stage.lights, first_mesh, shadows_change);
    if (shown) lights_.apply(loaded_);
}

scene::RenderScene SceneView::shown_stage() {
    auto shown = lights_alone();
    if (!shown) return loaded_.stage;
    shown->apply(loaded_);
    scene::RenderScene stage = loaded_.stage;
    lights_.apply(loaded_);
    return stage;
}

void SceneView::light_by(LightEditor edits) {
    edits.apply(loaded_);
    gpu_.relight(loaded_.stage.scene, loaded_.stage.lights, loaded_.base.meshes, false);
    lights_.apply(loaded_);
}

void SceneView::lights_changed() {
    render_->lights_changed();
    if (reference_) reference_->lights_changed();
}

void SceneView::pose(const gltf::AnimationTime& moment) {
    const gltf::AnimationTime before = loaded_.moment;
    try {
        show(moment);
    } catch (const Error&) {
        lights_.return_to(shown_);
        show(before);
        throw;
    }
    keep_shown();
}

void SceneView::show(const gltf::AnimationTime& moment) {
    viewer::pose(loaded_, moment);
    lights_.rebase(loaded_);
    lights_.apply(loaded_);
    const bool deforms = loaded_.contents.skins > 0 || loaded_.contents.morph_targets > 0;
    upload_lights(deforms ? 0 : loaded_.base.meshes, true);
    lights_changed();
}

void SceneView::take_edits(LightEditor lights) {
    lights_ = std::move(lights);
    lights_.rebase(loaded_);
    if (lights_.is_changed()) relight(true);
}

render::RenderOptions render_options(const Options& options, int width, int height) {
    render::RenderOptions rendering = options.rendering;
    rendering.width = width;
    rendering.height = height;
    rendering.samples = options.stop.samples;
    rendering.estimates_error = options.stop.asks_for_error();
    if (rendering.shader != render::RenderOptions().shader)
        rendering.estimator = render::Estimator::sampled; // views take points on the lights
    if (options.shows_reference) {
        rendering.shader_path = options.reference_path;
        return rendering;
    }
    rendering.shader_path.clear();
    for (const std::string& folder : options.shaders) {
        const glsl::Root root = glsl::Root::folder(folder);
        const bool is_untrusted =
            options.is_untrusted || folder == options.submission || folder == options.changed_code;
        rendering.shader_path.push_back(is_untrusted ? root.untrusted() : root);
    }
    rendering.shader_path.push_back(glsl::embedded());
    return rendering;
}

} // namespace sr::viewer
