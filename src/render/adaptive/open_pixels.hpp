#pragma once
// The triangles that pixels may see which still take samples.
#include "core/math.hpp"
#include "render/adaptive/converged_pixels.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace sr::render {

/// The faces of a mesh that are drawn: of those that turn clockwise on the picture, of the others, or all.
enum class Faces { counterclockwise, clockwise, all };

/// The pixels that are not frozen, counted by a summed-area table (Crow 1984).
class OpenPixels {
public:
    /// `frozen`: not 0 where a pixel is; rows from top to bottom.
    OpenPixels(const PixelMask& frozen, int width, int height);

    /// Returns whether one of these pixels is open.
    bool any_in(const PixelRect& rectangle) const;

    /// Returns the triangles that an open pixel may see from the camera with this matrix, whatever place
    /// within its pixel a sample looks at; in their order. Others may be among them. `indices`: three a
    /// triangle.
    std::vector<std::uint32_t> triangles_before(std::span<const vec3> positions,
                                                std::span<const std::uint32_t> indices,
                                                const mat4& world_from_object, const mat4& clip_from_world,
                                                Faces faces) const;

private:
    std::uint32_t count(int column, int row) const; // of the pixels above and left of this corner

    int width_;
    int height_;
    std::vector<std::uint32_t> counts_;
};

} // namespace sr::render
