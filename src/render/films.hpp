#pragma once
// The sums of a rendering's samples.
#include "render/film.hpp"
#include "render/visibility/pixel_sums.hpp"

#include <array>
#include <optional>

namespace sr::render {

/// The sums of all samples, or those of two halves apart (half_of()). What shaders write adds up in films on
/// the GPU. The light whose shadow rays the CPU traces adds up there (PixelSums), until somebody reads the
/// sum.
class Films {
public:
    /// @throws Error if the driver does not take the size.
    Films(int width, int height, Depths depths, bool has_halves);

    bool has_halves() const { return second_.has_value(); }
    /// The film of a half; 0 where there are none. All have one depth buffer.
    const RenderTarget& film(int half) const { return half == 0 ? first_ : *second_; }
    /// The part of this film's sum that lies on the CPU.
    PixelSums& sums(int half);
    void drop_sums() { sums_ = {}; }

    /// Call it after each sample, or part of one: sum() has to add up again.
    void changed() { is_sum_current_ = false; }

    /// Starts over. `window`: the part that has samples; `is_replaced`: the first sample takes the place of
    /// what the first film holds, which needs no clearing then.
    void clear(const PixelRect& window, bool is_replaced);

    /// The sums of all samples, RGBA.
    image::Image read() const;
    image::Image read_half(int half) const;
    std::array<float, 4> read(int column, int row) const; // of a pixel; row 0 is on top
    /// The sums of all samples, where shaders can read them. The CPU's move to the films for it.
    const gl::Texture& sum(ShaderLibrary& shaders) const;

private:
    RenderTarget first_; // with the depth buffer
    std::optional<RenderTarget> second_;
    mutable std::array<std::optional<PixelSums>, 2> sums_;
    mutable std::optional<RenderTarget> both_; // films added up
    mutable bool is_sum_current_ = false;
    gl::VertexArray no_vertices_{"no vertices"};
};

} // namespace sr::render
