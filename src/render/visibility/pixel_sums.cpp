#include "render/visibility/pixel_sums.hpp"

#include "render/gpu/blocks.hpp"

#include <algorithm>

namespace sr::render {
namespace {

constexpr int pixels_at_once = 1 << 18; // 3 MiB on their way to the driver

} // namespace

PixelSums::PixelSums(int width, int height)
    : width_(width),
      height_(height),
      sums_(std::size_t{3} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::span<float> PixelSums::row(int row) {
    const std::size_t floats = std::size_t{3} * static_cast<std::size_t>(width_);
    return std::span(sums_).subspan(floats * static_cast<std::size_t>(row), floats);
}

std::span<const float> PixelSums::row(int row) const {
    const std::size_t floats = std::size_t{3} * static_cast<std::size_t>(width_);
    return std::span(sums_).subspan(floats * static_cast<std::size_t>(row), floats);
}

void PixelSums::clear(const PixelRect& part) {
    for (int y = part.row; y < part.row + part.height; ++y) {
        const auto from = static_cast<std::size_t>(part.column),
                   pixels = static_cast<std::size_t>(part.width);
        std::ranges::fill(row(height_ - 1 - y).subspan(3 * from, 3 * pixels), 0.0f);
    }
}

void PixelSums::add_to(image::Image& film) const {
    auto pixel = film.pixels.begin();
    for (int y = 0; y < height_; ++y) {
        const std::span<const float> sums = row(height_ - 1 - y);
        for (std::size_t i = 0; i < sums.size(); i += 3, pixel += 4)
            for (int channel = 0; channel < 3; ++channel)
                pixel[channel] += sums[i + static_cast<std::size_t>(channel)];
    }
}

void PixelSums::add_to(std::array<float, 4>& texel, int column, int row_from_top) const {
    const std::span<const float> sums = row(height_ - 1 - row_from_top);
    for (std::size_t channel = 0; channel < 3; ++channel)
        texel[channel] += sums[3 * static_cast<std::size_t>(column) + channel];
}

void PixelSums::draw_into(const RenderTarget& target, const PixelRect& part, ShaderLibrary& shaders,
                          Pixels pixels) const {
    BufferTexture texture("the sums over shadow rays", GL_RGB32F); // of some rows
    const gl::Buffer rays("rays");
    const int rows_at_once = std::max(1, pixels_at_once / width_);
    const int first_row = height_ - part.row - part.height, end_row = height_ - part.row;
    glEnable(GL_SCISSOR_TEST);
    for (int first = first_row; first < end_row; first += rows_at_once) {
        const int rows = std::min(rows_at_once, end_row - first);
        const RaysBlock block{0, width_ * rows, width_, first, 0};
        glBindBuffer(GL_UNIFORM_BUFFER, rays.id());
        glBufferData(GL_UNIFORM_BUFFER, sizeof(block), &block, GL_STREAM_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, rays_block, rays.id());
        texture.fill<float>(
            std::size_t{3} * static_cast<std::size_t>(block.plane_size),
            [&](std::span<float> texels) { std::copy_n(row(first).data(), texels.size(), texels.data()); },
            "choose a smaller --size");
        texture.bind(ray_visibility_unit);
        glScissor(part.column, first, part.width, rows);
        add_pass(target, shaders, pixels);
    }
    glDisable(GL_SCISSOR_TEST);
}

} // namespace sr::render
