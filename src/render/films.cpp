#include "render/films.hpp"

#include <utility>

namespace sr::render {
namespace {

/// Keeps the framebuffers and the viewport for callers that draw.
class KeptTarget {
public:
    KeptTarget() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
        glGetIntegerv(GL_VIEWPORT, viewport_.data());
    }
    ~KeptTarget() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawn_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
        glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    }
    KeptTarget(const KeptTarget&) = delete;
    KeptTarget& operator=(const KeptTarget&) = delete;

private:
    GLint drawn_ = 0;
    GLint read_ = 0;
    std::array<GLint, 4> viewport_{};
};

void blacken(const RenderTarget& film) {
    film.bind();
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT);
}

} // namespace

Films::Films(int width, int height, Depths depths, bool has_halves) : first_("film", width, height, depths) {
    if (has_halves) second_.emplace("second half", first_);
}

PixelSums& Films::sums(int half) {
    auto& sums = sums_[static_cast<std::size_t>(half)];
    if (!sums) sums.emplace(first_.width(), first_.height());
    return *sums;
}

void Films::clear(const PixelRect& window, bool is_replaced) {
    changed();
    if (!is_replaced) blacken(first_);
    if (second_) blacken(*second_);
    for (auto& sums : sums_)
        if (sums) sums->clear(window);
}

image::Image Films::read_half(int half) const {
    image::Image image = film(half).read();
    if (const auto& sums = sums_[static_cast<std::size_t>(half)]) sums->add_to(image);
    return image;
}

image::Image Films::read() const {
    image::Image image = read_half(0);
    if (!second_) return image;
    const image::Image second = read_half(1);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] += second.pixels[i];
    return image;
}

std::array<float, 4> Films::read(int column, int row) const {
    std::array<float, 4> texel = first_.read(column, row);
    if (second_) {
        const std::array<float, 4> of_second = second_->read(column, row);
        for (std::size_t channel = 0; channel < texel.size(); ++channel) texel[channel] += of_second[channel];
    }
    for (const auto& sums : sums_)
        if (sums) sums->add_to(texel, column, row);
    return texel;
}

const gl::Texture& Films::sum(ShaderLibrary& shaders) const {
    if (std::exchange(is_sum_current_, true)) return both_ ? both_->color() : first_.color();
    const KeptTarget kept;
    const PixelRect whole{0, 0, first_.width(), first_.height()};
    glBindVertexArray(no_vertices_.id());
    for (const int half : {0, 1}) {
        auto& sums = sums_[static_cast<std::size_t>(half)];
        if (!sums) continue;
        sums->draw_into(film(half), whole, shaders, Pixels::all);
        sums->clear(whole);
    }
    if (!second_) return first_.color();
    if (!both_) both_.emplace("both halves", first_.width(), first_.height(), Depths::none);
    both_->copy(first_);
    accumulate_pass(*both_, *second_, shaders, Writing::adds, Pixels::all);
    return both_->color();
}

} // namespace sr::render
