#include "viewer/screen.hpp"

#include "glsl/root.hpp"

#include <array>

namespace sr::viewer {
namespace {

gl::Program screen_program() {
    const std::array path{glsl::embedded()};
    gl::Program program("screen", glsl::expand(path, "fullscreen.vert"),
                        glsl::expand(path, "display/screen.frag"));
    program.bind_texture("film_sum", 0);
    program.bind_texture("other_sum", 1);
    return program;
}

} // namespace

Screen::Screen() : program_(screen_program()) {}

void Screen::draw(const FilmSum& film, const FilmSum& other, const Look& look, int width, int height) const {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    program_.use();
    const auto weight = [](const FilmSum& f) { return 1.0f / static_cast<float>(f.samples); };
    const auto at = [this](const char* name) { return program_.uniform(name); };
    const bool is_compared = other.sum && look.comparison != Comparison::none;
    (is_compared ? other : film).sum->bind(1);
    film.sum->bind(0);
    glBindSampler(0, 0);
    glBindSampler(1, 0);
    glUniform1f(at("film_weight"), weight(film));
    glUniform1f(at("other_weight"), weight(other));
    glUniform2f(at("window_size"), static_cast<float>(width), static_cast<float>(height));
    glUniform1f(at("exposure"), image::exposure_factor(look.ev100));
    glUniform1i(at("curve"), static_cast<GLint>(look.curve));
    glUniform1i(at("is_false_color"), look.is_false_color);
    glUniform2f(at("false_color_range"), look.false_color_range.x, look.false_color_range.y);
    glUniform1i(at("comparison"), is_compared ? static_cast<GLint>(look.comparison) : 0);
    glUniform1f(at("wipe"), look.wipe);
    glBindVertexArray(no_vertices_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace sr::viewer
