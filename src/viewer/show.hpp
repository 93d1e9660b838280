#pragma once
// A scene on the GPU and its picture.
#include "viewer/document/light_edits.hpp"
#include "viewer/picture.hpp"

#include <memory>

namespace sr::viewer {

/// The parts refer to one another, so it stays where it is made.
class Show {
public:
    /// Uploads, compiles. @throws Error, ShaderError
    Show(LoadedScene scene, const Options& options, const scene::Camera& camera, int width, int height);
    Show(const Show&) = delete;
    Show& operator=(const Show&) = delete;

    const LoadedScene& scene() const { return scene_; }
    const render::GpuScene& gpu() const { return gpu_; }
    Picture& picture() { return *picture_; }
    const Picture& picture() const { return *picture_; }

    /// These are for both pictures, this one and the reference's.
    void resize(int width, int height);
    void move(const scene::Camera& camera);

    /// Adds samples to the picture by Options::reference_path, which the first call makes. @throws Error,
    /// ShaderError
    void advance_reference(const Options& options, const scene::Camera& camera, int width, int height);
    /// Null before that.
    const Picture* reference() const { return reference_.get(); }

    /// The picture anew, with the shaders as they are on disk now; where they do not compile the old one
    /// stays.
    /// @throws Error, ShaderError
    void make_picture(const Options& options, const scene::Camera& camera, int width, int height);

    /// Another way to find shadows, and the picture anew. @throws Error, ShaderError; then all is as it was
    void set_visibility(Options& options, render::Visibility visibility, const scene::Camera& camera,
                        int width, int height);

    /// What is edited; relight() brings it to the picture.
    LightEditor& lighting() { return lighting_; }
    const LightEditor& lighting() const { return lighting_; }
    /// `casters_change`: something that casts shadows has moved, come or gone. @throws Error
    void relight(bool casters_change);
    /// Brings the file to another moment, edits included. @throws Error if a value makes no sense then; the
    /// moment before is shown
    void pose(const gltf::Moment& moment);
    /// Goes on with what was edited in the same file, with other materials.
    void take_edits(LightEditor lighting);

    double upload_seconds() const { return upload_seconds_; }
    double compile_seconds() const { return compile_seconds_; }

private:
    LoadedScene scene_;
    double upload_seconds_ = 0.0;
    double compile_seconds_ = 0.0;
    render::GpuScene gpu_;
    LightEditor lighting_;
    std::unique_ptr<Picture> picture_;
    std::unique_ptr<Picture> reference_;
    render::Estimator reference_estimator_ = render::Estimator::sampled;
};

/// What the standing picture is rendered with, in a window of this size. @throws Error if a folder is none
render::RenderOptions render_options(const Options& options, int width, int height);

} // namespace sr::viewer
