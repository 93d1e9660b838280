#include "render/film.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::render {
namespace {

void require_size(int width, int height) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width > largest || height > largest)
        throw Error(fmt::format("a picture of {}×{} pixels is more than the driver's {} on a side", width,
                                height, largest),
                    "choose a smaller --size");
}

void allocate(GLint internal_format, GLenum format, GLenum type, int width, int height) {
    glTexImage2D(GL_TEXTURE_2D, 0, internal_format, width, height, 0, format, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

} // namespace

RenderTarget::RenderTarget(const char* name, int width, int height, Depths depths)
    : width_(width),
      height_(height),
      depths_(depths),
      color_(GL_TEXTURE_2D, name),
      depth_(GL_TEXTURE_2D, name),
      framebuffer_(name) {
    require_size(width, height);
    color_.bind(0);
    allocate(GL_RGBA32F, GL_RGBA, GL_FLOAT, width, height);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.id(), 0);
    depth_.bind(0);
    if (depths == Depths::plain) {
        allocate(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width, height);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    } else if (depths == Depths::with_stencils) {
        allocate(GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, width, height);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    }
    require_complete();
}

RenderTarget::RenderTarget(const char* name, const RenderTarget& with_depth)
    : RenderTarget(name, with_depth.width(), with_depth.height(), Depths::none) {
    const bool has_stencils = with_depth.depths() == Depths::with_stencils;
    glFramebufferTexture2D(GL_FRAMEBUFFER, has_stencils ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                           GL_TEXTURE_2D, with_depth.depth().id(), 0);
    require_complete();
}

void RenderTarget::require_complete() const {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE || glGetError() == GL_OUT_OF_MEMORY)
        throw Error(fmt::format("the driver refuses a float picture of {}×{} pixels (status {:#x})", width_,
                                height_, status),
                    "choose a smaller --size, or another --backend");
}

void RenderTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
}

void RenderTarget::copy(const RenderTarget& from) const {
    glDisable(GL_SCISSOR_TEST); // it cuts copies, too
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer_.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.id());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

image::Image RenderTarget::read() const {
    bind();
    image::Image image(width_, height_, 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, image.pixels.data());
    const std::size_t row = static_cast<std::size_t>(width_) * 4;
    for (int y = 0; y < height_ / 2; ++y) {
        const auto top =
            image.pixels.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y));
        const auto bottom =
            image.pixels.end() - static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y + 1));
        std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
    }
    return image;
}

std::array<float, 4> RenderTarget::read(int column, int row) const {
    bind();
    std::array<float, 4> texel{};
    glReadPixels(column, height_ - 1 - row, 1, 1, GL_RGBA, GL_FLOAT, texel.data());
    return texel;
}

} // namespace sr::render
