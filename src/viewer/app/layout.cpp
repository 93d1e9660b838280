#include "viewer/app/layout.hpp"

#include <algorithm>
#include <cmath>

namespace sr::viewer {
namespace {

// [pixels, before scaling]
constexpr float min_column = 230.0f;
constexpr float min_picture = 330.0f;  // width beside the left column
constexpr float min_height = 320.0f;   // of a window with docked panels
constexpr float right_column = 420.0f; // at most
constexpr float min_right_column = 230.0f;

constexpr float picture_share = 0.5f;    // of the window's width, that the picture keeps at least
constexpr float right_share = 0.27f;     // of the window's width
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
    below_ = excess_ = tabs_ = 0.0f;
    sides_.clear();
    if (!is_same) { // the strips are taken to be as high as they were
        rest_ = {{0.0f, insets_.x}, {window.x, window.y - insets_.x - insets_.y}};
        film_ = picture_ = middle();
        last_bottom_ = window.y;
    }
    rest_ = {vec2(0.0f), window};
}

void Layout::end() {
    last_sides_ = sides_;
    last_below_ = below_;
    last_bottom_ = rest_.from.y + rest_.size.y;
    if (std::ranges::find(sides_, front_) == sides_.end()) front_ = side::controls;
    film_ = picture_ = middle();
    if (!is_docked_) return;
    film_.size.y += excess_;
    picture_.size.y = std::max(min_side, picture_.size.y - below_);
    insets_ = {film_.from.y, window_.y - film_.from.y - film_.size.y};
}

bool Layout::has_one_column() const {
    return is_docked_ && (min_column + min_right_column) * scale_ > (1.0f - picture_share) * window_.x;
}

/// Width of the right column; 0 if no panel takes a part of it.
float Layout::right_width() const {
    if (has_one_column() || (sides_.empty() && last_sides_.empty())) return 0.0f;
    const float widest = (1.0f - picture_share) * window_.x - min_column * scale_;
    const float wanted = std::min(right_column * scale_, right_share * window_.x);
    return std::floor(std::min(std::max(min_right_column * scale_, wanted), widest));
}

/// Lower edge of what is left, once strips are taken that a later tool will take.
float Layout::bottom() const { return std::min(rest_.from.y + rest_.size.y, last_bottom_); }

/// The rest between the columns; the whole window if panels are not docked.
Area Layout::middle() const {
    if (!is_docked_) return {vec2(0.0f), window_};
    const float left = this->left().size.x;
    return {{left, rest_.from.y}, glm::max(vec2(min_side), {window_.x - left - right_width(), rest_.size.y})};
}

vec2 Layout::column_range() const {
    const float widest =
        std::min((1.0f - picture_share) * window_.x - right_width(), window_.x - min_picture * scale_);
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

Area Layout::take_tabs(float height) {
    const Area column = left();
    tabs_ = std::ceil(height);
    return {column.from, {column.size.x, tabs_}};
}

Area Layout::left() const {
    const vec2 range = column_range();
    const float below = has_one_column() ? std::max(below_, last_below_) : 0.0f;
    return {{rest_.from.x, rest_.from.y + tabs_},
            {std::floor(std::clamp(column_ * scale_, range.x, range.y)),
             std::max(min_side, bottom() - rest_.from.y - tabs_ - below)}};
}

PanelPlace Layout::take_side(const std::string& name) {
    const bool is_new = std::ranges::find(last_sides_, name) == last_sides_.end();
    const auto part = static_cast<float>(sides_.size());
    sides_.push_back(name);
    if (is_new) front_ = name;
    if (!is_docked_) return {};
    if (has_one_column()) return {front_ == name, left()};
    const auto count = static_cast<float>(std::max(sides_.size(), last_sides_.size()));
    const float width = right_width(), height = std::floor((bottom() - rest_.from.y) / count);
    return {true, Area{{window_.x - width, rest_.from.y + part * height}, {width, height}}};
}

Area Layout::take_below_picture(float height) {
    const Area between = middle();
    below_ = std::floor(std::min(height, max_below_share * between.size.y));
    const float y = bottom() - below_;
    if (has_one_column()) return {{0.0f, y}, {window_.x, below_}};
    return {{between.from.x, y}, {between.size.x, below_}};
}

std::vector<std::string> Layout::tabs() const {
    std::vector<std::string> names{side::controls};
    names.insert(names.end(), last_sides_.begin(), last_sides_.end());
    return names;
}

bool Layout::bring_forward(const std::string& name) {
    const bool is_behind = has_one_column() && front_ != name;
    front_ = name;
    return is_behind;
}

} // namespace sr::viewer
