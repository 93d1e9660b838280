#pragma once
// A scene on the GPU, its light editor and its progressive render.
#include "viewer/document/light_edits.hpp"
#include "viewer/view/progressive_render.hpp"

#include <memory>
#include <optional>
#include <set>
#include <utility>

namespace sr::viewer {

/// The parts refer to one another, so a SceneView does not move.
class SceneView {
public:
    /// Uploads the scene and compiles the shaders. @throws Error, ShaderError
    SceneView(LoadedScene loaded, const Options& options, const scene::Camera& camera, int width, int height);
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    const LoadedScene& loaded() const { return loaded_; }
    const scene::RenderScene& stage() const { return loaded_.stage; }
    const render::GpuScene& gpu() const { return gpu_; }
    ProgressiveRender& render() { return *render_; }
    const ProgressiveRender& render() const { return *render_; }

    /// The camera that frames the file's contents in a picture of this width / height.
    scene::Camera framing_camera(float aspect_ratio);

    // These three are for both renders, this one and the reference's.
    void resize(int width, int height);
    void move(const scene::Camera& camera);
    /// Applies the edits of lights() and hide(). `shadows_change`: something that casts shadows has moved,
    /// come or gone. @throws Error if they cannot be shown; they are taken back then
    void relight(bool shadows_change);

    /// Applies the edits of lights() to stage() alone: the GPU keeps its lights until relight().
    void stage_lights() { lights_.apply(loaded_); }
    /// Lights the GPU by other edits than lights(), for renders besides render(), until relight(). @throws
    /// Error
    void light_by(LightEditor edits);

    /// Lights the picture by one entry of lights() alone, enabled or not, or by all if it is absent, once
    /// relight() runs. No edit: stage() has all lights.
    void light_alone(std::optional<std::size_t> entry) { alone_ = entry; }
    std::optional<std::size_t> alone() const { return alone_; }
    /// A copy of stage() with the lights that light the picture.
    scene::RenderScene shown_stage();

    /// Adds samples to the render with Options::reference_path, which the first call makes. @throws Error,
    /// ShaderError
    void advance_reference(const Options& options, const scene::Camera& camera, int width, int height);
    /// Null before the first call of advance_reference().
    const ProgressiveRender* reference() const { return reference_.get(); }

    /// Replaces the render by a new one, with the shaders as they are on disk. If they do not compile, the
    /// old render stays. @throws Error, ShaderError
    void restart(const Options& options, const scene::Camera& camera, int width, int height);

    /// Changes the visibility method and restarts. @throws Error, ShaderError; then nothing has changed
    void set_visibility(Options& options, render::Visibility visibility, const scene::Camera& camera,
                        int width, int height);

    /// Hides these objects from the picture, from shadows and from the lights, and shows all others, once
    /// relight() runs.
    void hide(std::set<ObjectId> objects) { loaded_.hidden = std::move(objects); }

    LightEditor& lights() { return lights_; }
    const LightEditor& lights() const { return lights_; }
    /// Shows the file at another time, with the edits. @throws Error if a value makes no sense then, or the
    /// GPU has no room for it; the time before stays
    void pose(const gltf::AnimationTime& moment);
    /// Takes over edits that were made to the same file with other materials. @throws Error if they cannot
    /// be shown
    void take_edits(LightEditor lights);

    double upload_seconds() const { return upload_seconds_; }
    double compile_seconds() const { return compile_seconds_; }

private:
    void show_edits(bool shadows_change);
    void show(const gltf::AnimationTime& moment);
    void keep_shown();
    void lights_changed();
    std::optional<LightEditor> lights_alone() const;
    void upload_lights(std::size_t first_mesh, bool shadows_change);

    LoadedScene loaded_;
    double upload_seconds_ = 0.0;
    double compile_seconds_ = 0.0;
    render::GpuScene gpu_;
    LightEditor lights_;
    LightEditor::State shown_; // edits that the GPU has
    std::set<ObjectId> shown_hidden_;
    std::optional<std::size_t> alone_; // entry that lights the picture
    std::unique_ptr<ProgressiveRender> render_;
    std::unique_ptr<ProgressiveRender> reference_;
    render::Estimator reference_estimator_ = render::Estimator::sampled;
    std::string reference_shader_;
};

/// Options of the converging render in a window of this size. @throws Error if a shader folder is missing
render::RenderOptions render_options(const Options& options, int width, int height);

} // namespace sr::viewer
