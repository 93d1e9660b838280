#pragma once
// Progressive render of the view: coarse and quick during interaction, then converging, then converged.
#include "render/adaptive/convergence.hpp"
#include "render/renderer.hpp"
#include "viewer/view/presenter.hpp"

#include <chrono>

namespace sr::viewer {

/// Scale of the sides of an interactive render: 1, or a power of 2^(-1/4) down to an eighth. It shrinks after
/// two long samples in a row (one may be another program's fault) or a single very long one. It grows after
/// several samples that leave room for the next step.
class Resolution {
public:
    /// `frame`: the time between two frames to aim at [s].
    explicit Resolution(double frame) : frame_(frame) {}

    float scale() const;
    /// Time that a sample at scale() may take [s].
    double budget() const;
    /// Reports the time of a frame outside its sample, such as presenting it [s]. The budget shrinks by it.
    void took_besides(double seconds);
    /// Reports the time of a sample at scale() [s].
    void took(double seconds);

private:
    double frame_;
    double besides_ = 0.0;
    double excess_before_ = 0.0;
    int step_ = 8; // a quarter of the sides: nothing is known yet
    int fitting_ = 0;
};

class ProgressiveRender {
public:
    using Clock = std::chrono::steady_clock;

    /// `options` and `rule` are those of the converging render, which equals the picture of `steradian
    /// render`. Compiles its programs. @throws Error, ShaderError
    ProgressiveRender(const render::GpuScene& scene, const scene::Camera& camera,
                      const render::RenderOptions& options, const render::StopRule& rule);

    void resize(int width, int height);
    /// Restarts with another camera, at first at an interactive resolution.
    void move(const scene::Camera& camera);
    /// Restarts after GpuScene::relight(). @throws ShaderError, Error
    void lights_changed();

    /// Adds samples for a short while: the next one of an interactive render, or a part of a converging
    /// one's.
    void advance();

    bool is_interactive() const { return is_interactive_; }
    bool is_converged() const { return !is_interactive_ && monitor_.stopped_by().has_value(); }

    /// Samples of what is shown; 0 if there is nothing to show yet.
    int sample_count() const { return is_kept_shown_ ? kept_samples_ : renderer_.sample_count(); }
    /// Complete samples at the resolution of the current render, shown or not.
    int complete_samples() const { return renderer_.sample_count(); }
    int light_choices() const { return renderer_.light_choices(); }
    const render::StopRule& rule() const { return monitor_.rule(); }
    /// Why the converging render is complete; absent if it is not.
    std::optional<render::StoppedBy> stopped_by() const {
        return is_interactive_ ? std::nullopt : monitor_.stopped_by();
    }
    /// √relMSE of the converging render; absent before the first estimate.
    std::optional<double> error() const { return is_interactive_ ? std::nullopt : monitor_.error(); }
    float scale() const { return resolution_.scale(); } // of the sides, during interaction
    double seconds_per_sample() const { return seconds_; }
    /// Time of the samples of the converging render so far, and the rays that the CPU traced for them.
    struct SampleTimes {
        int samples = 0;
        double seconds = 0.0;
        std::optional<render::TracedRays> rays;  // absent where the CPU traces none
        std::optional<render::PassTimes> passes; // absent unless they were measured from the first sample on
    };
    /// Measures the parts of samples, for which the GPU is waited for after each, or measures them no more.
    void measure_passes(bool measures);
    SampleTimes sample_times() const;

    /// The complete samples. A converging render without any shows the interactive one.
    FilmSum shown() const;
    image::Image read_film() const;
    /// Mean of the samples of one pixel; `place` from 0 at the upper left corner to 1.
    vec3 pixel(vec2 place) const;

private:
    void begin_interactive();
    void begin_converging();
    void keep();
    void update_frozen_weights();
    int kept_samples_of(std::size_t pixel) const;
    void advance_interactive();
    void advance_converging();

    bool is_software_; // GL runs on the CPU
    Resolution resolution_;
    Clock::time_point interactive_sample_end_{};
    gl::Framebuffer reading_{"reading a film"};
    render::Renderer renderer_;
    scene::Camera camera_;
    int width_;
    int height_;
    render::StopMonitor monitor_;
    std::optional<gl::Texture> frozen_weights_; // as FilmSum::frozen_weights
    bool is_interactive_ = true;
    Clock::time_point changed_{};               // the last change of camera, size or lights
    double seconds_ = 0.0;                      // of the last complete sample
    double spent_ = 0.0;                        // on the incomplete sample [s]
    double sampled_ = 0.0;                      // time of the complete samples of the converging render [s]
    std::optional<render::TracedRays> rays_;    // after the last complete sample
    std::optional<render::TracedRays> no_rays_; // before the first one
    bool measures_passes_ = false;
    render::PassTimes passes_;                      // of the samples so far, the one at hand included
    std::optional<render::PassTimes> whole_passes_; // after the last complete sample
    /// Copy of the film before a sample that takes several calls, or before the render became a converging
    /// one.
    std::optional<render::RenderTarget> kept_;
    int kept_width_ = 0;
    int kept_height_ = 0;
    int kept_samples_ = 0;
    bool is_kept_shown_ = false;
};

/// Describes the progress: "24 of 256 samples, error 1.3 % (stops at 0.5 %), 12.4 ms each".
std::string progress_of(const ProgressiveRender& render);

} // namespace sr::viewer
