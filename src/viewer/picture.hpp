#pragma once
// The progressive picture: coarse and quick while something moves, converging when it stands, done at last.
#include "render/renderer.hpp"
#include "viewer/resolution.hpp"
#include "viewer/rest_weights.hpp"
#include "viewer/screen.hpp"
#include "viewer/stopping.hpp"

#include <chrono>

namespace sr::viewer {

class Picture {
public:
    using Clock = std::chrono::steady_clock;

    /// `options` and `rule` are those of the standing picture, which is the one that `steradian render` makes
    /// of them. Compiles its programs. @throws Error, ShaderError
    Picture(const render::GpuScene& scene, const scene::Camera& camera, const render::RenderOptions& options,
            const render::StopRule& rule);

    void resize(int width, int height);
    /// Another camera: starts over, for a moment at the resolution that is quick enough.
    void move(const scene::Camera& camera);
    /// The scene's lights have changed (GpuScene::relight).
    void relit();

    /// Adds samples for a short while: a moving picture's next one, or a part of a standing picture's.
    void advance();

    bool is_moving() const { return is_moving_; }
    /// Every sample of the standing picture is there: there is nothing left to draw.
    bool is_done() const { return !is_moving_ && stopping_.is_done(); }

    /// The samples of what is shown; 0: nothing can be shown yet.
    int sample_count() const { return is_kept_shown_ ? kept_samples_ : renderer_.sample_count(); }
    const render::StopRule& rule() const { return stopping_.rule(); }
    /// How far the standing picture is from converged, √relMSE; absent before the first look at it.
    std::optional<double> error() const { return is_moving_ ? std::nullopt : stopping_.error(); }
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
    int kept_samples_of(std::size_t pixel) const;
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
    Stopping stopping_;
    RestWeights rest_weights_;
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

/// "24 of 256 samples, error 1.3 % of 0.5 %, 12.4 ms each": how far it is.
std::string progress_of(const Picture& picture);

} // namespace sr::viewer
