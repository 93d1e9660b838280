#include "viewer/view/presenter.hpp"

#include "glsl/root.hpp"

#include <array>
#include <fmt/format.h>

namespace sr::viewer {
namespace {

/// The curve is in display/shown_curve.glsl instead.
std::string constants(const image::ToneCurve*, const output::Variable* view, ComparisonMode comparison,
                      bool is_scaled, bool is_film_displayed, bool is_reference_displayed,
                      bool has_frozen_pixels) {
    const bool is_false_color =
        view && (view->display == output::Display::false_color || view->display == output::Display::count);
    return fmt::format("const bool is_false_color = {};\n"
                       "const int comparison = {};\nconst bool is_scaled = {};\n"
                       "const bool is_film_displayed = {};\n"
                       "const bool is_other_displayed = {};\nconst bool has_frozen_pixels = {};\n{}{}",
                       is_false_color, static_cast<int>(comparison), is_scaled, is_film_displayed,
                       is_reference_displayed, has_frozen_pixels, image::colormap_glsl(), view_glsl(view));
}

} // namespace

std::string view_glsl(const output::Variable* view) {
    using output::Display, output::Finish;
    int kind = 0;
    if (view && (view->display == Display::share || view->display == Display::leaks))
        kind = view->finish == Finish::quotient ? 2 : view->finish == Finish::leaks ? 3 : 1;
    return fmt::format("const int view_kind = {};\nconst float view_without = {:.1f};\n", kind,
                       view ? view->without : 0.0f);
}

const gl::Program& Presenter::program(const Choice& choice) {
    if (const auto found = programs_.find(choice); found != programs_.end()) return found->second;
    const std::array path{
        glsl::Root::memory("screen",
                           {{"display/choice.glsl", std::apply(constants, choice)},
                            {"display/shown_curve.glsl", image::tone_curve_glsl(*std::get<0>(choice))}}),
        glsl::embedded()};
    gl::Program program("screen", glsl::expand(path, "fullscreen.vert"),
                        glsl::expand(path, "display/screen.frag"));
    program.bind_texture("film_sum", 0);
    program.bind_texture("other_sum", 1);
    program.bind_texture("pixel_weights", 2);
    return programs_.emplace(choice, std::move(program)).first->second;
}

Presenter::Codes::Codes(int columns, int rows) : width(columns), height(rows) {
    texture.bind(0);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
}

void Presenter::draw(const FilmSum& film, const FilmSum& reference, const DisplaySettings& settings,
                     const ScreenRectangle& place) {
    const bool is_compared = reference.sum && settings.comparison != ComparisonMode::none;
    if (settings.zoom.factor > 1) {
        fill_codes(film, reference, settings);
        return enlarge(film, settings.zoom, place);
    }
    if (is_compared || (film.width == place.width && film.height == place.height)) {
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return fill(film, reference, settings, place);
    }
    fill_codes(film, {}, settings);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, film.width, film.height, place.x, place.y, place.x + place.width,
                      place.y + place.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Presenter::fill_codes(const FilmSum& film, const FilmSum& reference, const DisplaySettings& settings) {
    if (!codes_ || codes_->width != film.width || codes_->height != film.height)
        codes_.emplace(film.width, film.height);
    glBindFramebuffer(GL_FRAMEBUFFER, codes_->framebuffer.id());
    fill(film, reference, settings, {0, 0, film.width, film.height});
}

/// Copies a part of the code values, each as a square. An interactive film has fewer pixels, which are
/// larger.
void Presenter::enlarge(const FilmSum& film, const PixelZoom& zoom, const ScreenRectangle& place) {
    const vec2 picture(place.width, place.height), all(film.width, film.height), size(zoom.size);
    const vec2 upper_left(place.x, place.y + place.height);
    const vec2 scale = all / size, from(zoom.from);
    const glm::ivec2 first = glm::floor(from * scale);
    const glm::ivec2 end = glm::min(all, glm::ceil((from + size / static_cast<float>(zoom.factor)) * scale));
    const auto in_window = [&](glm::ivec2 pixel) { // GL's first row is the lowest
        const vec2 at = (vec2(pixel) / scale - from) * static_cast<float>(zoom.factor) * picture / size;
        return glm::ivec2(glm::round(upper_left + vec2(at.x, -at.y)));
    };
    const glm::ivec2 upper = in_window(first), lower = in_window(end);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glEnable(GL_SCISSOR_TEST);
    glScissor(place.x, place.y, place.width, place.height);
    glBlitFramebuffer(first.x, film.height - end.y, end.x, film.height - first.y, upper.x, lower.y, lower.x,
                      upper.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Presenter::fill(const FilmSum& film, const FilmSum& reference, const DisplaySettings& settings,
                     const ScreenRectangle& place) {
    const auto [x, y, width, height] = place;
    glViewport(x, y, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    const bool is_compared = reference.sum && settings.comparison != ComparisonMode::none;
    const auto fits = [&](const FilmSum& f) { return f.width == place.width && f.height == place.height; };
    const bool is_scaled = !fits(film) || (is_compared && !fits(reference));
    const gl::Program& used =
        program({settings.curve, settings.view, is_compared ? settings.comparison : ComparisonMode::none,
                 is_scaled, film.is_display_referred, is_compared && reference.is_display_referred,
                 film.frozen_weights != nullptr});
    used.use();
    const auto weight = [](const FilmSum& f) { return 1.0f / static_cast<float>(f.samples); };
    const auto at = [&](const char* name) { return used.uniform(name); };
    (is_compared ? reference : film).sum->bind(1);
    film.sum->bind(0);
    if (film.frozen_weights) film.frozen_weights->bind(2);
    glBindSampler(2, 0);
    glBindSampler(0, 0);
    glBindSampler(1, 0);
    glUniform1f(at("film_weight"), weight(film));
    glUniform1f(at("other_weight"), weight(reference));
    glUniform2f(at("corner"), static_cast<float>(x), static_cast<float>(y));
    glUniform2f(at("picture_size"), static_cast<float>(width), static_cast<float>(height));
    glUniform1f(at("exposure"), image::exposure_factor(settings.ev100));
    const bool is_count = settings.view && settings.view->display == output::Display::count;
    const image::Decades& decades = is_count ? output::count_decades : settings.decades;
    glUniform2f(at("decades"), decades.first, decades.last);
    glUniform1f(at("wipe"), settings.wipe);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace sr::viewer
