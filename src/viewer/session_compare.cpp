// Questions to the picture: what a pixel is made of, and how it differs from another picture.
#include "viewer/session.hpp"

#include "core/error.hpp"
#include "core/luminance.hpp"
#include "render/lobe.hpp"
#include "render/provenance.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace sr::viewer {

/// The equation at the pixel. It takes a while: keys and pointer wait, Esc stops it.
void Session::answer_question() {
    playback_.is_playing = false; // the answer is that of a moment
    const vec2 place = place_of(*question_);
    question_.reset();
    constexpr int most_samples = 64; // the terms of one pixel take as long as a small picture
    render::RenderOptions options = render_options(options_, width_, height_);
    options.samples = std::min(options.samples, most_samples);
    options.knows_error = false;
    const int column = std::clamp(static_cast<int>(place.x * static_cast<float>(width_)), 0, width_ - 1);
    const int row = std::clamp(static_cast<int>(place.y * static_cast<float>(height_)), 0, height_ - 1);
    const auto goes_on = [this] {
        glfwPollEvents();
        return !input_.wants_to_stop();
    };
    auto terms = render::probe(show_->gpu(), eye_->camera(), options, column, row, goes_on);
    if (!terms) return say("the question was taken back");
    probe_.answer = Answer{*std::move(terms), {}, {}, column, row, height_, options.samples};
    if (marks_ && !options_.shows_reference) {
        render::RenderOptions theirs = options;
        theirs.shader_path = options_.reference_path;
        probe_.answer->reference = render::probe(show_->gpu(), eye_->camera(), theirs, column, row, goes_on);
    }
    probe_.answer->lobe = lobe_of(probe_.answer->terms, options, column, row);
    say(fmt::format("pixel {},{} answers", column, row));
    frames_to_draw_ = 3;
}

/// f_r all around, and along each light. Absent where nothing is seen.
std::optional<Lobe> Session::lobe_of(const render::PixelTerms& terms, const render::RenderOptions& options,
                                     int column, int row) const {
    if (terms.n == vec3(0.0f) || terms.wo == vec3(0.0f)) return std::nullopt;
    Lobe lobe;
    lobe.n = glm::normalize(terms.n);
    lobe.wo = glm::normalize(terms.wo);
    lobe.wi = lobe_directions(lobe.n, lobe.wo);
    std::vector<vec3> asked = lobe.wi;
    for (const render::LightTerms& light : terms.lights) {
        lobe.light_wi.push_back(light.wi == vec3(0.0f) ? vec3(0.0f) : glm::normalize(light.wi));
        asked.push_back(light.wi == vec3(0.0f) ? lobe.n : lobe.light_wi.back());
    }
    const auto brdf = render::brdf_at(show_->gpu(), eye_->camera(), options, column, row, asked);
    if (!brdf) return std::nullopt;
    lobe.is_mirror = brdf->is_mirror;
    for (std::size_t i = 0; i < asked.size(); ++i)
        (i < lobe.wi.size() ? lobe.f_r : lobe.light_f_r).push_back(luminance(brdf->f_r[i]));
    return lobe;
}

void Session::obey(const CompareWish& wish) {
    if (wish.keeps) keep_picture();
    if (wish.loads) dialog_.show(FileDialog::Purpose::compare, show_->scene().file);
    if (wish.wants_flip) begin_flip();
    if (wish.estimator) change_estimator(*wish.estimator);
    if (wish.visibility) change_visibility(*wish.visibility);
}

void Session::change_estimator(render::Estimator estimator) {
    const render::Estimator before = options_.rendering.estimator;
    options_.rendering.estimator = estimator;
    try {
        show_->make_picture(options_, eye_->camera(), width_, height_);
        measured_samples_ = 0;
    } catch (const Error& error) {
        options_.rendering.estimator = before;
        fail("The estimator cannot be changed.", error.what());
    }
}

void Session::change_visibility(render::Visibility visibility) {
    try {
        show_->set_visibility(options_, visibility, eye_->camera(), width_, height_);
        measured_samples_ = 0;
    } catch (const Error& error) {
        fail("Shadows cannot be found that way.", error.what());
    }
}

void Session::keep_picture() {
    const Picture& picture = show_->picture();
    if (picture.sample_count() == 0) return;
    reference_.emplace(fmt::format("{} samples, {}, {}", picture.sample_count(),
                                   render::name_of(options_.rendering.estimator), eye_->argument()),
                       picture.film());
    if (look_.comparison == Comparison::none) look_.comparison = Comparison::wipe;
    say("kept: B goes through the ways to compare with it");
}

void Session::load_reference(const std::string& file) {
    try {
        reference_ = read_reference(file);
        if (look_.comparison == Comparison::none) look_.comparison = Comparison::wipe;
        error_text_.clear();
        say("beside " + reference_->name() + ": B goes through the ways to compare with it");
    } catch (const Error& error) {
        fail("There is nothing to compare with.", error.what());
    }
}

void Session::next_comparison() {
    if (!reference_ && !marks_) return keep_picture();
    const int count = reference_ ? 4 : 3; // there is no FLIP map against a picture that still gathers samples
    look_.comparison = static_cast<Comparison>((static_cast<int>(look_.comparison) + 1) % count);
    if (look_.comparison == Comparison::flip) begin_flip();
    constexpr std::array names{"this picture alone", "wipe", "difference", "FLIP map"};
    say(names[static_cast<std::size_t>(look_.comparison)]);
}

/// On a thread of its own: a large picture takes seconds.
void Session::begin_flip() {
    if (flipping_ || !reference_ || show_->picture().sample_count() == 0) return;
    flip_result_ = "working ...";
    flipping_ = std::async(std::launch::async, [film = show_->picture().film(), other = reference_->film(),
                                                look = look_, is_displayed = reference_->is_displayed()] {
        return is_displayed ? flip_of_displayed(film, look, other) : flip_of(film, other);
    });
}

void Session::take_flip() {
    if (!flipping_ || flipping_->wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    auto flipping = std::exchange(flipping_, std::nullopt);
    frames_to_draw_ = 3;
    try {
        FlipMap map = flipping->get();
        flip_result_ = fmt::format("mean FLIP {:.4f}", map.mean);
        flip_.emplace("FLIP", std::move(map.film));
        say(flip_result_);
    } catch (const Error& error) {
        flip_result_ = error.what();
        say(flip_result_);
    }
}

FilmSum Session::other_film() const {
    if (look_.comparison == Comparison::flip) return flip_ ? flip_->sum() : FilmSum{};
    if (reference_) return reference_->sum();
    const Picture* theirs = shows_reference_beside() ? show_->reference() : nullptr;
    return theirs && theirs->sample_count() > 0 ? theirs->shown() : FilmSum{};
}

} // namespace sr::viewer
