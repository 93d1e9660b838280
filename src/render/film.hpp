#pragma once
// The Film: linear radiance, one RGBA32F texel a pixel.
#include "gl/object.hpp"
#include "image/image.hpp"

#include <algorithm>
#include <array>

namespace sr::render {

/// The buffers of a target besides its colours.
enum class Depths { none, plain, with_stencils };

/// A colour texture of 32-bit floats that can be drawn into, with a depth buffer if asked for.
class RenderTarget {
public:
    /// @throws Error if the driver does not take the size.
    RenderTarget(const char* name, int width, int height, Depths depths);
    /// One of the same size that is drawn into under the depth and the stencils of another, which outlives
    /// it.
    /// @throws Error as above
    RenderTarget(const char* name, const RenderTarget& with_depth);

    /// Makes it the target of drawing, whole.
    void bind() const;
    int width() const { return width_; }
    int height() const { return height_; }
    const gl::Texture& color() const { return color_; }
    const gl::Texture& depth() const { return depth_; }
    Depths depths() const { return depths_; }

    /// Copies the colours of a picture of the same size.
    void copy(const RenderTarget& from) const;

    /// The texels with the picture's first row on top; RGBA.
    image::Image read() const;
    /// One texel; `row` counts from the picture's first row.
    std::array<float, 4> read(int column, int row) const;

private:
    void require_complete() const;

    int width_;
    int height_;
    Depths depths_;
    gl::Texture color_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
};

// A rectangle of pixels.

/// A part of a picture, counted from its upper left corner.
struct PixelRect {
    int column = 0;
    int row = 0;
    int width = 0;
    int height = 0;

    bool is_empty() const { return width <= 0 || height <= 0; }
};

/// Returns the intersection of both rectangles.
inline PixelRect common_part(const PixelRect& a, const PixelRect& b) {
    const int column = std::max(a.column, b.column), row = std::max(a.row, b.row);
    const int end_column = std::min(a.column + a.width, b.column + b.width);
    const int end_row = std::min(a.row + a.height, b.row + b.height);
    return {column, row, std::max(0, end_column - column), std::max(0, end_row - row)};
}

} // namespace sr::render
