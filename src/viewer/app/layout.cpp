#include "viewer/app/layout.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {
namespace {

// [pixels, before scaling]
constexpr float min_column = 230.0f;
constexpr float min_picture = 330.0f;      // width beside the left column
constexpr float min_height = 320.0f;       // of a window with docked panels
constexpr float right_column = 420.0f;     // at most
constexpr float min_right_column = 230.0f; // if the window has that share

constexpr float max_left_share = 0.5f;   // of the window's width
constexpr float right_share = 0.27f;     // of the window's width
constexpr float max_right_share = 0.34f; // likewise, where right_share is too narrow
constexpr float max_below_share = 0.42f; // of the height between the columns
constexpr float min_side = 32.0f;        // of the picture

} // namespace

Area fitted_into(const Area& room, float aspect_ratio) {
    vec2 size = room.size;
    if (size.x > size.y * aspect_ratio)
        size.x = std::round(size.y * aspect_ratio);
    else
        size.y = std::round(size.x / aspect_ratio);
    return {room.from + glm::floor(0.5f * (room.size - size)), size};
}

void Layout::begin(vec2 window, float scale, bool has_panels) {
    const bool is_same = window == window_ && scale == scale_ && has_panels == has_panels_;
    window_ = window;
    scale_ = scale;
    has_panels_ = has_panels;
    is_docked_ =
        has_panels && window.x >= (min_column + min_picture) * scale && window.y >= min_height * scale;
    below_ = excess_ = 0.0f;
    right_parts_ = 0;
    if (!is_same) { // the strips are taken to be as high as they were
        rest_ = {{0.0f, insets_.x}, {window.x, window.y - insets_.x - insets_.y}};
        film_ = picture_ = middle();
    }
    rest_ = {vec2(0.0f), window};
}

void Layout::end() {
    right_count_ = right_parts_;
    film_ = picture_ = middle();
    if (!is_docked_) return;
    film_.size.y += excess_;
    picture_.size.y = std::max(min_side, picture_.size.y - below_);
    insets_ = {film_.from.y, window_.y - film_.from.y - film_.size.y};
}

/// The rest between the columns; the whole window if panels are not docked.
Area Layout::middle() const {
    if (!is_docked_) return {vec2(0.0f), window_};
    const float left = this->left().size.x;
    const bool has_right = std::max(right_parts_, right_count_) > 0;
    const float narrowest = std::min(min_right_column * scale_, max_right_share * window_.x);
    const float wanted = std::min(right_column * scale_, right_share * window_.x);
    const float right = has_right ? std::floor(std::max(narrowest, wanted)) : 0.0f;
    return {{left, rest_.from.y}, glm::max(vec2(min_side), {window_.x - left - right, rest_.size.y})};
}

vec2 Layout::column_range() const {
    const float widest = std::min(max_left_share * window_.x, window_.x - min_picture * scale_);
    return {min_column * scale_, std::max(min_column * scale_, widest)};
}

Area Layout::take_top(float height) {
    const Area area{rest_.from, {rest_.size.x, std::ceil(height)}};
    rest_.from.y += area.size.y;
    rest_.size.y -= area.size.y;
    return area;
}

Area Layout::take_bottom(float height, float steady) {
    const float taken = std::ceil(std::max(height, steady));
    rest_.size.y -= taken;
    excess_ += taken - std::ceil(steady);
    return {{rest_.from.x, rest_.from.y + rest_.size.y}, {rest_.size.x, taken}};
}

Area Layout::left() const {
    const vec2 range = column_range();
    return {rest_.from, {std::floor(std::clamp(column_ * scale_, range.x, range.y)), rest_.size.y}};
}

Area Layout::take_right() {
    const int part = right_parts_++;
    const int count = std::max(right_parts_, right_count_);
    const Area between = middle();
    const float x = between.from.x + between.size.x,
                height = std::floor(rest_.size.y / static_cast<float>(count));
    return {{x, rest_.from.y + static_cast<float>(part) * height}, {window_.x - x, height}};
}

Area Layout::take_below_picture(float height) {
    const Area between = middle();
    below_ = std::floor(std::min(height, max_below_share * between.size.y));
    return {{between.from.x, between.from.y + between.size.y - below_}, {between.size.x, below_}};
}

} // namespace sr::viewer
