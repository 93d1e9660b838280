#pragma once
// L_r as the CPU adds it up.
#include "image/image.hpp"
#include "render/film.hpp"
#include "render/gpu/gpu_texture.hpp"
#include "render/gpu/shader_library.hpp"
#include "render/passes.hpp"

#include <array>
#include <span>
#include <vector>

namespace sr::render {

/// Sums over the samples of each pixel of a picture [cd/m²]. Samples cost less where their sums stay on the
/// CPU until a film is read.
class PixelSums {
public:
    PixelSums(int width, int height);

    /// Three floats for each pixel of a row, which is counted from the lower edge.
    std::span<float> row(int row);
    std::span<const float> row(int row) const;

    /// Sets the sums of `part` to 0.
    void clear(const PixelRect& part);
    /// Adds them to RGB of an image of this size, whose first row is on top.
    void add_to(image::Image& film) const;
    /// Adds those of a pixel to its RGB.
    void add_to(std::array<float, 4>& texel, int column, int row_from_top) const;
    /// Adds those of `part` to the target, by add_pass() under a vertex array without vertices.
    void draw_into(const RenderTarget& target, const PixelRect& part, ShaderLibrary& shaders,
                   Pixels pixels) const;

private:
    int width_;
    int height_;
    std::vector<float> sums_;
};

} // namespace sr::render
