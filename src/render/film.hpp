#pragma once
// The Film: linear radiance, one RGBA32F texel a pixel.
#include "gl/object.hpp"
#include "image/image.hpp"

namespace sr::render {

/// A colour texture of 32-bit floats that can be drawn into, with a depth buffer if asked for.
class RenderTarget {
public:
    /// @throws Error if the driver does not take the size.
    RenderTarget(const char* name, int width, int height, bool has_depth);

    /// Makes it the target of drawing, whole.
    void bind() const;
    int width() const { return width_; }
    int height() const { return height_; }
    const gl::Texture& color() const { return color_; }
    const gl::Texture& depth() const { return depth_; }

    /// The texels with the picture's first row on top; RGBA.
    image::Image read() const;

private:
    int width_;
    int height_;
    gl::Texture color_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
};

} // namespace sr::render
