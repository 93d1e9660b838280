#include "render/adaptive/open_pixels.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sr::render {
namespace {

/// A corner on the picture [pixels], rows from top to bottom.
struct Corner {
    vec2 place{0.0f};
    float error = 0.0f;            // by which a driver may place it elsewhere [pixels]
    bool is_before_camera = false; // for certain
};

/// Drivers round corners to 1/256 of a pixel, which may turn a triangle of less than this area [pixels²] for
/// each pixel of its extent.
constexpr float turned_by_snapping = 1.0f / 64.0f;

/// Samples look at most half a pixel beside a pixel's centre; the other half is for snapping.
constexpr float margin = 1.0f; // [pixels]

/// The share of the largest terms by which sums of a few products may differ: drivers add them in other
/// orders.
constexpr float rounding = 1.0f / 1048576.0f;

mat4 magnitudes(const mat4& m) { return {glm::abs(m[0]), glm::abs(m[1]), glm::abs(m[2]), glm::abs(m[3])}; }

/// Places corners as mesh.vert does.
class Placement {
public:
    Placement(const mat4& world_from_object, const mat4& clip_from_world, vec2 size)
        : world_from_object_(world_from_object),
          clip_from_world_(clip_from_world),
          magnitudes_(magnitudes(clip_from_world) * magnitudes(world_from_object)),
          half_size_(0.5f * size) {}

    Corner of(vec3 position) const {
        const vec4 clip = clip_from_world_ * (world_from_object_ * vec4(position, 1.0f));
        const vec4 error = rounding * (magnitudes_ * vec4(glm::abs(position), 1.0f));
        const vec2 ndc = vec2(clip.x, -clip.y) / clip.w;
        const vec2 moved = half_size_ * 2.0f * (vec2(error) + glm::abs(ndc) * error.w) / clip.w;
        return {half_size_ + half_size_ * ndc, std::max(moved.x, moved.y), clip.w > 2.0f * error.w};
    }

private:
    mat4 world_from_object_;
    mat4 clip_from_world_;
    mat4 magnitudes_; // of the terms, from object to clip space
    vec2 half_size_;  // [pixels]
};

class Triangle {
public:
    explicit Triangle(const std::array<Corner, 3>& corners) : corners_(corners) {
        for (const Corner& corner : corners) {
            is_before_camera_ = is_before_camera_ && corner.is_before_camera;
            error_ = std::max(error_, corner.error);
            min_ = glm::min(min_, corner.place);
            max_ = glm::max(max_, corner.place);
        }
    }

    /// False if the camera's plane may cut it, or a corner is not finite.
    bool has_outline() const {
        return is_before_camera_ && std::isfinite(min_.x + min_.y + max_.x + max_.y + error_);
    }

    /// Returns whether its front may be seen.
    bool may_face(Faces faces) const {
        if (faces == Faces::all) return true;
        const vec2 a = corners_[1].place - corners_[0].place, b = corners_[2].place - corners_[0].place;
        const float clockwise = a.x * b.y - a.y * b.x; // rows go down
        const float extent = 1.0f + max_.x - min_.x + max_.y - min_.y;
        const float uncertain = extent * (turned_by_snapping + 4.0f * error_ + rounding * extent);
        return !((faces == Faces::clockwise ? clockwise : -clockwise) < -uncertain); // NaN: it may
    }

    /// The pixels that it may cover, clipped to the picture.
    PixelRect pixels(int width, int height) const {
        const vec2 size(width, height);
        const glm::ivec2 first(glm::floor(glm::clamp(min_ - margin - error_, vec2(0.0f), size)));
        const glm::ivec2 end(glm::ceil(glm::clamp(max_ + margin + error_, vec2(0.0f), size)));
        return {first.x, first.y, end.x - first.x, end.y - first.y};
    }

private:
    std::array<Corner, 3> corners_;
    bool is_before_camera_ = true;
    float error_ = 0.0f; // [pixels]
    vec2 min_{std::numeric_limits<float>::max()};
    vec2 max_{std::numeric_limits<float>::lowest()};
};

} // namespace

OpenPixels::OpenPixels(const PixelMask& frozen, int width, int height)
    : width_(width),
      height_(height),
      counts_(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1), 0) {
    require(frozen.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
            "the mask has the picture's size");
    const auto columns = static_cast<std::size_t>(width) + 1;
    auto pixel = frozen.begin();
    for (std::size_t above = 0; above + columns < counts_.size(); above += columns) {
        std::uint32_t of_row = 0;
        for (std::size_t i = above + columns + 1; i < above + 2 * columns; ++i) {
            of_row += *pixel++ == 0 ? 1 : 0;
            counts_[i] = counts_[i - columns] + of_row;
        }
    }
}

std::uint32_t OpenPixels::count(int column, int row) const {
    return counts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_ + 1)
                   + static_cast<std::size_t>(column)];
}

bool OpenPixels::any_in(const PixelRect& rectangle) const {
    const PixelRect part = common_part(rectangle, {0, 0, width_, height_});
    if (part.is_empty()) return false;
    const auto [column, row, width, height] = part;
    return count(column + width, row + height) + count(column, row)
           > count(column + width, row) + count(column, row + height);
}

std::vector<std::uint32_t> OpenPixels::triangles_before(std::span<const vec3> positions,
                                                        std::span<const std::uint32_t> indices,
                                                        const mat4& world_from_object,
                                                        const mat4& clip_from_world, Faces faces) const {
    const Placement placement(world_from_object, clip_from_world, vec2(width_, height_));
    std::vector<Corner> corners;
    corners.reserve(positions.size());
    for (const vec3& position : positions) corners.push_back(placement.of(position));
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const Triangle triangle({corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]});
        if (triangle.has_outline()
            && (!triangle.may_face(faces) || !any_in(triangle.pixels(width_, height_))))
            continue;
        kept.push_back(static_cast<std::uint32_t>(i / 3));
    }
    return kept;
}

} // namespace sr::render
