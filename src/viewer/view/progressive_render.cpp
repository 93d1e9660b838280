#include "viewer/view/progressive_render.hpp"

#include "gl/context.hpp"
#include "viewer/view/turns.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sr::viewer {
namespace {

using namespace std::chrono_literals;

constexpr double software_frame = 0.050; // [s] between two interactive frames in software GL
constexpr double gpu_frame = 1.0 / 60.0; // [s] likewise on a GPU
constexpr double gpu_besides = 0.006;    // [s] of it reserved: waiting for the screen looks like work
constexpr auto max_besides = 150ms;      // between two samples: after more the interaction had paused
constexpr int interactive_samples = 4;   // that an interactive render gathers while nothing changes
constexpr auto settling_time = 180ms;    // without a change, until the render converges

// Of Resolution.
constexpr int max_step = 12; // an eighth of the sides
constexpr int frames_to_grow = 3;
constexpr double min_share = 0.3;  // of a frame that a sample has in any case
constexpr double step_slack = 0.6; // [steps] over the budget, 1.23 times it: no reason to shrink
constexpr double steps_far = 2.5;  // [steps], 2.4 times the budget

int scaled(int side, float scale) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(side) * scale)));
}

bool is_software() {
    return gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}

/// A render begins interactively, so that something is there at once.
render::RenderOptions first_options(render::RenderOptions options, float scale) {
    options.width = scaled(options.width, scale);
    options.height = scaled(options.height, scale);
    options.samples = interactive_samples;
    return options;
}

double seconds_since(ProgressiveRender::Clock::time_point begin) {
    glFinish(); // so that the GPU's time counts
    return std::chrono::duration<double>(ProgressiveRender::Clock::now() - begin).count();
}

} // namespace

float Resolution::scale() const { return std::exp2(-0.25f * static_cast<float>(step_)); }

double Resolution::budget() const { return std::max(frame_ - besides_, min_share * frame_); }

void Resolution::took_besides(double seconds) { besides_ += 0.2 * (std::min(seconds, frame_) - besides_); }

void Resolution::took(double seconds) {
    // A step scales the number of pixels by 2^(-1/2); time is assumed to be proportional to pixels.
    const double excess = 2.0 * std::log2(std::max(seconds, 1e-6) / budget());
    if (excess > step_slack) {
        fitting_ = 0;
        const double certain = excess > steps_far ? excess : std::min(excess, excess_before_);
        if (certain > step_slack) step_ = std::min(max_step, step_ + static_cast<int>(std::ceil(certain)));
        excess_before_ = certain > step_slack ? 0.0 : excess;
        return;
    }
    excess_before_ = 0.0;
    if (excess > -1.0 || step_ == 0) {
        fitting_ = 0;
    } else if (++fitting_ == frames_to_grow) {
        step_ = std::max(0, step_ + static_cast<int>(std::ceil(excess)));
        fitting_ = 0;
    }
}

ProgressiveRender::ProgressiveRender(const render::GpuScene& scene, const scene::Camera& camera,
                                     const render::RenderOptions& options, const render::StopRule& rule)
    : is_software_(is_software()),
      resolution_(is_software_ ? software_frame : gpu_frame - gpu_besides),
      renderer_(scene, camera, first_options(options, resolution_.scale())),
      camera_(camera),
      width_(options.width),
      height_(options.height),
      monitor_(rule) {
    renderer_.compile();
    changed_ = Clock::now();
}

void ProgressiveRender::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    begin_interactive();
}

void ProgressiveRender::move(const scene::Camera& camera) {
    camera_ = camera;
    begin_interactive();
}

void ProgressiveRender::lights_changed() {
    is_interactive_ = false; // so that the renderer is resized, which makes it read the lights
    begin_interactive();
    renderer_.compile(); // other kinds of light need other programs
}

void ProgressiveRender::begin_interactive() {
    changed_ = Clock::now();
    const int width = scaled(width_, resolution_.scale());
    const int height = scaled(height_, resolution_.scale());
    if (!is_interactive_ || width != renderer_.width() || height != renderer_.height())
        renderer_.resize(width, height, interactive_samples);
    renderer_.look_from(camera_);
    is_interactive_ = true;
    is_kept_shown_ = false;
    frozen_weights_.reset();
}

void ProgressiveRender::begin_converging() {
    keep();
    is_interactive_ = false;
    const double pixels =
        static_cast<double>(width_) * height_ / (static_cast<double>(renderer_.width()) * renderer_.height());
    seconds_ *= pixels; // the expected time of the first sample
    spent_ = 0.0;
    monitor_.restart();
    renderer_.resize(width_, height_, rule().samples);
    renderer_.look_from(camera_);
    sampled_ = 0.0;
    rays_ = no_rays_ = renderer_.traced_rays();
    passes_ = {};
    whole_passes_.reset();
    if (measures_passes_) whole_passes_.emplace();
}

void ProgressiveRender::measure_passes(bool measures) {
    if (measures == measures_passes_) return;
    measures_passes_ = measures;
    renderer_.measure_passes(measures ? &passes_ : nullptr);
    whole_passes_.reset(); // they would lack the samples so far, or those that follow
}

ProgressiveRender::SampleTimes ProgressiveRender::sample_times() const {
    if (is_interactive_) return {};
    SampleTimes times{renderer_.sample_count(), sampled_, rays_, whole_passes_};
    if (times.rays && no_rays_) {
        times.rays->count -= no_rays_->count;
        times.rays->seconds -= no_rays_->seconds;
    }
    return times;
}

/// Shows a copy of the film until the next sample is complete.
void ProgressiveRender::keep() {
    if (renderer_.sample_count() == 0) return;
    const int width = renderer_.width(), height = renderer_.height();
    if (!kept_ || kept_width_ != width || kept_height_ != height)
        kept_.emplace("kept film", kept_width_ = width, kept_height_ = height, render::Depths::none);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reading_.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           renderer_.film_sum().id(), 0);
    kept_->color().bind(0);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
    kept_samples_ = renderer_.sample_count();
    is_kept_shown_ = true;
}

void ProgressiveRender::update_frozen_weights() {
    constexpr int endless = std::numeric_limits<int>::max();
    const auto width = static_cast<std::size_t>(width_), height = static_cast<std::size_t>(height_);
    std::vector<float> weights(width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const int samples = renderer_.converged_pixels().samples_of(y * width + x, endless);
            weights[(height - 1 - y) * width + x] =
                samples == endless ? 0.0f : 1.0f / static_cast<float>(samples);
        }
    frozen_weights_.emplace(GL_TEXTURE_2D, "weights of frozen pixels");
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width_, height_, 0, GL_RED, GL_FLOAT, weights.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

FilmSum ProgressiveRender::shown() const {
    const gl::Texture* weights = frozen_weights_ ? &*frozen_weights_ : nullptr;
    if (is_kept_shown_) return {&kept_->color(), kept_samples_, kept_width_, kept_height_, weights};
    return {&renderer_.film_sum(), sample_count(), renderer_.width(), renderer_.height(), weights};
}

image::Image ProgressiveRender::read_film() const {
    if (!is_kept_shown_) return renderer_.read_film();
    image::Image image = kept_->read();
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] *= 1.0f / static_cast<float>(kept_samples_of(i / 4));
    return image;
}

/// An interactive render has no frozen pixels, and can be what is kept.
int ProgressiveRender::kept_samples_of(std::size_t pixel) const {
    return frozen_weights_ ? renderer_.converged_pixels().samples_of(pixel, kept_samples_) : kept_samples_;
}

vec3 ProgressiveRender::pixel(vec2 place) const {
    const FilmSum film = shown();
    const auto at = [](float part, int size) {
        return std::clamp(static_cast<int>(part * static_cast<float>(size)), 0, size - 1);
    };
    const int column = at(place.x, film.width), row = at(place.y, film.height);
    vec4 sum(0.0f);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reading_.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, film.sum->id(), 0);
    glReadPixels(column, film.height - 1 - row, 1, 1, GL_RGBA, GL_FLOAT, &sum.x);
    const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(film.width)
                       + static_cast<std::size_t>(column);
    const int samples =
        film.frozen_weights ? renderer_.converged_pixels().samples_of(index, film.samples) : film.samples;
    return vec3(sum) / static_cast<float>(samples);
}

void ProgressiveRender::advance() {
    if (is_interactive_ && renderer_.sample_count() > 0 && Clock::now() - changed_ > settling_time)
        begin_converging();
    if (is_interactive_)
        advance_interactive();
    else
        advance_converging();
}

void ProgressiveRender::advance_interactive() {
    if (renderer_.sample_count() >= interactive_samples) return;
    const bool is_first = renderer_.sample_count() == 0;
    const auto begin = Clock::now();
    const std::chrono::duration<double> besides = begin - interactive_sample_end_;
    if (is_software_ && besides < max_besides) resolution_.took_besides(besides.count());
    renderer_.add_sample();
    seconds_ = seconds_since(begin);
    if (is_first) resolution_.took(seconds_);
    interactive_sample_end_ = Clock::now();
    is_kept_shown_ = false;
}

/// Adds as many whole samples as fit, or a part of a sample that takes longer.
void ProgressiveRender::advance_converging() {
    const auto begin = Clock::now();
    double spent = 0.0;
    while (!is_converged() && spent < turn_budget) {
        const double expected = std::max(seconds_, spent_);
        const bool is_short = expected <= turn_budget;
        if (!is_short && spent_ == 0.0) keep();
        const int rows = is_short ? height_ : rows_of_turn(height_, expected, turn_budget);
        const bool is_complete = renderer_.add_rows(rows);
        const double now = seconds_since(begin);
        spent_ += now - spent;
        spent = now;
        if (!is_complete) continue;
        seconds_ = spent_;
        sampled_ += spent_;
        rays_ = renderer_.traced_rays();
        if (whole_passes_) whole_passes_ = passes_;
        spent_ = 0.0;
        is_kept_shown_ = false;
        if (monitor_.took_sample(renderer_, seconds_)) update_frozen_weights();
    }
}

std::string progress_of(const ProgressiveRender& render) {
    const double seconds = render.seconds_per_sample();
    const std::string time =
        seconds < 1.0 ? fmt::format("{:.1f} ms", 1e3 * seconds) : fmt::format("{:.1f} s", seconds);
    if (render.is_interactive())
        return fmt::format("interactive at {:.0f} %, {} a sample", 100.0f * render.scale(), time);
    const render::StopRule& rule = render.rule();
    const int samples = render.complete_samples();
    std::string text = render.is_converged() ? fmt::format("done, {} samples", samples)
                                             : fmt::format("{} of {} samples", samples, rule.samples);
    if (const auto error = render.error()) text += fmt::format(", error {:.2g} %", 100.0 * *error);
    if (rule.error && !render.is_converged())
        text += fmt::format(" (stops at {:.2g} %)", 100.0 * *rule.error);
    if (rule.seconds) text += fmt::format(", at most {:.3g} s", *rule.seconds);
    return samples > 0 ? text + fmt::format(", {} each", time) : text; // before the first one it is a guess
}

} // namespace sr::viewer
