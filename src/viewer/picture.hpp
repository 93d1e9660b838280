#pragma once
// The progressive picture: coarse and quick while something moves, converging when it stands, done at last.
#include "render/renderer.hpp"
#include "viewer/resolution.hpp"

#include <chrono>

namespace sr::viewer {

class Picture {
public:
    using Clock = std::chrono::steady_clock;

    /// `options` are those of the standing picture, which is the one that `steradian render` makes of them.
    /// Compiles its programs. @throws Error, ShaderError
    Picture(const render::GpuScene& scene, const scene::Camera& camera, const render::RenderOptions& options);

    void resize(int width, int height);
    /// Another camera, or (`camera` as it was) other lights: starts over, for a moment at the resolution that
    /// is quick enough.
    void move(const scene::Camera& camera);
    /// The scene's lights have changed (GpuScene::relight).
    void relit();

    /// Adds samples for a short while, at least one unless it is done.
    void advance();

    bool is_moving() const { return is_moving_; }
    /// Every sample of the standing picture is there: there is nothing left to draw.
    bool is_done() const { return !is_moving_ && renderer_.sample_count() >= samples_; }

    int sample_count() const { return renderer_.sample_count(); }
    int samples() const { return samples_; }
    float scale() const { return is_moving_ ? resolution_.scale() : 1.0f; }
    double seconds_per_sample() const { return seconds_; }
    const gl::Texture& film_sum() const { return renderer_.film_sum(); }
    image::Image film() const { return renderer_.film(); }
    /// The mean of one pixel's samples, counted from the upper left corner of the standing picture.
    vec3 pixel(int column, int row) const;

private:
    void start_moving();
    void stand();
    double timed_sample();

    gl::Framebuffer reading_{"reading a pixel"};
    render::Renderer renderer_;
    scene::Camera camera_;
    int width_;
    int height_;
    int samples_;
    bool is_moving_ = false;
    Clock::time_point moved_{};
    Resolution resolution_;
    double seconds_ = 0.0;
};

} // namespace sr::viewer
