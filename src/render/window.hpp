#pragma once
// A part of a picture.

namespace sr::render {

/// A part of a picture, counted from its upper left corner.
struct Window {
    int column = 0;
    int row = 0;
    int width = 0;
    int height = 0;

    bool is_empty() const { return width <= 0 || height <= 0; }
};

/// What lies in both.
Window common_part(const Window& a, const Window& b);

} // namespace sr::render
