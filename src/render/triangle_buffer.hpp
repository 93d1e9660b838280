#pragma once
// The triangle that each pixel sees, so that finely meshed surfaces are shaded pixel by pixel.
#include "render/adaptive/open_pixels.hpp"
#include "render/film.hpp"
#include "render/gpu/gpu_scene.hpp"
#include "render/gpu/shader_library.hpp"

#include <string>
#include <vector>

namespace sr::render {

/// A visibility buffer (Burns & Hunt 2013) of the draws that have numbers. A driver that runs on
/// the CPU shades blocks of pixels, and a block once for each triangle in it, so that small triangles cost
/// several times their pixels. Here one large triangle shades each pixel once, by
/// shaders/interface/seen_triangle.glsl.
class TriangleBuffer {
public:
    /// Returns whether the current context runs on the CPU and a draw of the scene has a number.
    static bool is_useful(const GpuScene& scene);

    /// Of the size of `frame`, whose depths and stencils it shares and which outlives it.
    /// @throws Error if the driver does not take it
    explicit TriangleBuffer(const RenderTarget& frame);

    /// From now on the depth pre-pass draws what these pixels may see from a camera with this matrix,
    /// whatever place within its pixel a sample looks at. Others see surfaces that they do not see.
    void draw_before(const OpenPixels& open, const GpuScene& scene, const mat4& clip_from_world);
    /// From now on it draws all.
    void draw_all() { selections_.clear(); }

    /// Makes it the target of the depth pre-pass, for a camera with this matrix.
    void begin(const GpuScene& scene, const mat4& clip_from_world);

    /// Of the depth pre-pass: pixels get the number of this draw.
    void write_number(const Draw& draw) const;
    /// Of the depth pre-pass: draws this draw, which has a number, by this program of depth_shader_of().
    void draw(const GpuScene& scene, const Draw& draw, const gl::Program& program) const;

    /// Shades the pixels of the scissor that see a draw with a number, by `fragment` and `terms`, into the
    /// bound framebuffer, which has the frame's stencils; blending stays as it is.
    void shade(const GpuScene& scene, ShaderLibrary& shaders, const std::string& fragment,
               ProgramTerms terms) const;

private:
    int width_;
    int height_;
    gl::Texture triangles_{GL_TEXTURE_2D, "seen triangles"};
    gl::Framebuffer framebuffer_{"seen triangles"};
    gl::VertexArray no_vertices_{"no vertices"};
    std::vector<PixelRect> rectangles_;         // that the draws may cover, by number - 1; rows from below
    std::vector<TriangleSelection> selections_; // by number - 1; empty: all triangles are drawn
};

} // namespace sr::render
