#include "viewer/picture.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {
namespace {

using namespace std::chrono_literals;

// With what the window and its panels take, this leaves some 20 frames a second in software GL.
constexpr double moving_budget = 0.035; // [s] a sample
constexpr int moving_samples = 4;       // that a moving picture gathers while the hand rests
constexpr auto settled = 180ms;         // of rest, until the picture stands
constexpr auto standing_budget = 30ms;  // of samples between two drawings of the window

int scaled(int side, float scale) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(side) * scale)));
}

} // namespace

Picture::Picture(const render::GpuScene& scene, const scene::Camera& camera,
                 const render::RenderOptions& options)
    : renderer_(scene, camera, options),
      camera_(camera),
      width_(options.width),
      height_(options.height),
      samples_(options.samples),
      resolution_(moving_budget) {
    renderer_.compile();
}

void Picture::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    stand();
}

void Picture::move(const scene::Camera& camera) {
    camera_ = camera;
    start_moving();
}

void Picture::relit() {
    is_moving_ = false; // the renderer must hear of the lights in any case
    start_moving();
}

void Picture::start_moving() {
    moved_ = Clock::now();
    const int width = scaled(width_, resolution_.scale());
    const int height = scaled(height_, resolution_.scale());
    if (!is_moving_ || width != renderer_.width() || height != renderer_.height())
        renderer_.resize(width, height, moving_samples);
    is_moving_ = true;
    renderer_.look_from(camera_);
}

void Picture::stand() {
    is_moving_ = false;
    renderer_.resize(width_, height_, samples_);
    renderer_.look_from(camera_);
}

vec3 Picture::pixel(int column, int row) const {
    vec4 sum(0.0f);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reading_.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           renderer_.film_sum().id(), 0);
    glReadPixels(column, renderer_.height() - 1 - row, 1, 1, GL_RGBA, GL_FLOAT, &sum.x);
    return vec3(sum) / static_cast<float>(renderer_.sample_count());
}

double Picture::timed_sample() {
    const auto begin = Clock::now();
    renderer_.add_sample();
    glFinish(); // so that the time is the sample's
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

void Picture::advance() {
    if (is_moving_ && renderer_.sample_count() > 0 && Clock::now() - moved_ > settled) stand();
    if (is_moving_) {
        if (renderer_.sample_count() >= moving_samples) return;
        const bool is_first = renderer_.sample_count() == 0;
        seconds_ = timed_sample();
        if (is_first) resolution_.took(seconds_);
        return;
    }
    const auto begin = Clock::now();
    while (!is_done()) {
        seconds_ = timed_sample();
        if (Clock::now() - begin > standing_budget) return;
    }
}

} // namespace sr::viewer
