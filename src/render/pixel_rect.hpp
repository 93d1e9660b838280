#pragma once
// A rectangle of pixels.
#include <algorithm>

namespace sr::render {

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
