#include "viewer/picture.hpp"

#include "gl/context.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::viewer {
namespace {

using namespace std::chrono_literals;

constexpr double software_frame = 0.050; // [s] from one moving frame to the next, where GL is software
constexpr double gpu_frame = 1.0 / 60.0; // [s] likewise on a GPU
constexpr double gpu_others =
    0.006; // [s] of it left for all else: waiting for the screen cannot be told from work
constexpr auto longest_others = 150ms;    // between two samples: after more the hand had rested
constexpr int moving_samples = 4;         // that a moving picture gathers while the hand rests
constexpr auto settled = 180ms;           // of rest, until the picture stands
constexpr double standing_budget = 0.040; // [s] of sampling between two looks at keys and pointer
constexpr int most_parts = 10; // of a sample: each reads all the scene's vertices anew, several times

int scaled(int side, float scale) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(side) * scale)));
}

bool is_software() {
    return gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
}

/// A picture begins as if it had moved: coarse, and there at once.
render::RenderOptions first_options(render::RenderOptions options, float scale) {
    options.width = scaled(options.width, scale);
    options.height = scaled(options.height, scale);
    options.samples = moving_samples;
    return options;
}

double seconds_since(Picture::Clock::time_point begin) {
    glFinish(); // so that it is the GPU's time, too
    return std::chrono::duration<double>(Picture::Clock::now() - begin).count();
}

} // namespace

Picture::Picture(const render::GpuScene& scene, const scene::Camera& camera,
                 const render::RenderOptions& options, const render::StopRule& rule)
    : is_software_(is_software()),
      resolution_(is_software_ ? software_frame : gpu_frame - gpu_others),
      renderer_(scene, camera, first_options(options, resolution_.scale())),
      camera_(camera),
      width_(options.width),
      height_(options.height),
      stopping_(rule) {
    renderer_.compile();
    moved_ = Clock::now();
}

void Picture::resize(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    start_moving();
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
    renderer_.look_from(camera_);
    is_moving_ = true;
    is_kept_shown_ = false;
    rest_weights_.clear();
}

void Picture::stand() {
    keep();
    is_moving_ = false;
    const double pixels =
        static_cast<double>(width_) * height_ / (static_cast<double>(renderer_.width()) * renderer_.height());
    seconds_ *= pixels; // what the first sample can be expected to take
    spent_ = 0.0;
    stopping_.begin();
    renderer_.resize(width_, height_, stopping_.rule().samples);
    renderer_.look_from(camera_);
}

/// Shows a copy of the film until the next sample is complete.
void Picture::keep() {
    if (renderer_.sample_count() == 0) return;
    const int width = renderer_.width(), height = renderer_.height();
    if (!kept_ || kept_width_ != width || kept_height_ != height)
        kept_.emplace("kept film", kept_width_ = width, kept_height_ = height, false);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, reading_.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           renderer_.film_sum().id(), 0);
    kept_->color().bind(0);
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, width, height);
    kept_samples_ = renderer_.sample_count();
    is_kept_shown_ = true;
}

FilmSum Picture::shown() const {
    const gl::Texture* rests = rest_weights_.texture();
    if (is_kept_shown_) return {&kept_->color(), kept_samples_, kept_width_, kept_height_, rests};
    return {&renderer_.film_sum(), sample_count(), renderer_.width(), renderer_.height(), rests};
}

image::Image Picture::film() const {
    if (!is_kept_shown_) return renderer_.film();
    image::Image image = kept_->read();
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] *= 1.0f / static_cast<float>(kept_samples_of(i / 4));
    return image;
}

/// No pixel of a moving picture rests, which can be what is kept.
int Picture::kept_samples_of(std::size_t pixel) const {
    return rest_weights_.texture() ? renderer_.resting().samples_of(pixel, kept_samples_) : kept_samples_;
}

vec3 Picture::pixel(vec2 place) const {
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
        film.rest_weights ? renderer_.resting().samples_of(index, film.samples) : film.samples;
    return vec3(sum) / static_cast<float>(samples);
}

void Picture::advance() {
    if (is_moving_ && renderer_.sample_count() > 0 && Clock::now() - moved_ > settled) stand();
    if (is_moving_)
        advance_moving();
    else
        advance_standing();
}

void Picture::advance_moving() {
    if (renderer_.sample_count() >= moving_samples) return;
    const bool is_first = renderer_.sample_count() == 0;
    const auto begin = Clock::now();
    const std::chrono::duration<double> others = begin - moving_sample_end_;
    if (is_software_ && others < longest_others) resolution_.others_took(others.count());
    renderer_.add_sample();
    seconds_ = seconds_since(begin);
    if (is_first) resolution_.took(seconds_);
    moving_sample_end_ = Clock::now();
    is_kept_shown_ = false;
}

/// As many whole samples as fit, or a part of one that takes longer.
void Picture::advance_standing() {
    const auto begin = Clock::now();
    double spent = 0.0;
    while (!is_done() && spent < standing_budget) {
        const double expected = std::max(seconds_, spent_);
        const bool is_short = expected <= standing_budget;
        if (!is_short && spent_ == 0.0) keep();
        const int rows = is_short ? height_
                                  : std::max((height_ + most_parts - 1) / most_parts,
                                             static_cast<int>(height_ * standing_budget / expected));
        const bool is_complete = renderer_.add_rows(rows);
        const double now = seconds_since(begin);
        spent_ += now - spent;
        spent = now;
        if (!is_complete) continue;
        seconds_ = spent_;
        spent_ = 0.0;
        is_kept_shown_ = false;
        if (stopping_.took_sample(renderer_, seconds_))
            rest_weights_.take(renderer_.resting(), width_, height_);
    }
}

std::string progress_of(const Picture& picture) {
    const double ms = 1e3 * picture.seconds_per_sample();
    if (picture.is_moving())
        return fmt::format("moving at {:.0f} %, {:.1f} ms a sample", 100.0f * picture.scale(), ms);
    const render::StopRule& rule = picture.rule();
    std::string text = picture.is_done()
                           ? fmt::format("done, {} samples", picture.sample_count())
                           : fmt::format("{} of {} samples", picture.sample_count(), rule.samples);
    if (const auto error = picture.error()) text += fmt::format(", error {:.2g} %", 100.0 * *error);
    if (rule.error)
        text += fmt::format("{} of {:.2g} %", picture.error() ? "" : ", error", 100.0 * *rule.error);
    if (rule.seconds) text += fmt::format(", {:.3g} s at most", *rule.seconds);
    return text + fmt::format(", {:.1f} ms each", ms);
}

} // namespace sr::viewer
