#pragma once
// The progressive picture: coarse and quick while something moves, converging when it stands, done at last.
#include "render/renderer.hpp"
#include "viewer/resolution.hpp"
#include "viewer/screen.hpp"

#include <chrono>

namespace sr::viewer {

class Picture {
public:
    using Clock = std::chrono::steady_clock;

    /// `options` are those of the standing picture, which is the one that `steradian render` makes of them.
    /// Compiles its programs. @throws Error, ShaderError
    Picture(const render::GpuScene& scene, const scene::Camera& camera, const render::RenderOptions& options);

    void resize(int width, int height);
    /// Another camera: starts over, for a moment at the resolution that is quick enough.
    void move(const scene::Camera& camera);
    /// The scene's lights have changed (GpuScene::relight).
    void relit();

    /// Adds samples for a short while: a moving picture's next one, or a part of a standing picture's.
    void advance();

    bool is_moving() const { return is_moving_; }
    /// Every sample of the standing picture is there: there is nothing left to draw.
    bool is_done() const { return !is_moving_ && renderer_.sample_count() >= samples_; }

    /// The samples of what is shown; 0: nothing can be shown yet.
    int sample_count() const { return is_kept_shown_ ? kept_samples_ : renderer_.sample_count(); }
    int samples() const { return samples_; }
    float scale() const { return resolution_.scale(); } // of a moving picture's sides
    double seconds_per_sample() const { return seconds_; }

    /// What is shown: the samples that are complete. A standing picture that has none yet shows the moving
    /// one.
    FilmSum shown() const;
    image::Image film() const;
    /// The mean of one pixel's samples; the place counted from the upper left corner, 0 to 1.
    vec3 pixel(vec2 place) const;

private:
    void start_moving();
    void stand();
    void keep();
    void advance_moving();
    void advance_standing();

    bool is_software_; // GL runs on the CPU
    Resolution resolution_;
    Clock::time_point moving_sample_end_{};
    gl::Framebuffer reading_{"reading a film"};
    render::Renderer renderer_;
    scene::Camera camera_;
    int width_;
    int height_;
    int samples_;
    bool is_moving_ = true;
    Clock::time_point moved_{};
    double seconds_ = 0.0; // that the last complete sample took
    double spent_ = 0.0;   // on the sample that is not complete
    /// The film as it was before a sample that takes several calls, or before the picture stood.
    std::optional<render::Target> kept_;
    int kept_width_ = 0;
    int kept_height_ = 0;
    int kept_samples_ = 0;
    bool is_kept_shown_ = false;
};

} // namespace sr::viewer
