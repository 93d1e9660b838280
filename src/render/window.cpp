#include "render/window.hpp"

#include <algorithm>

namespace sr::render {

Window common_part(const Window& a, const Window& b) {
    const int column = std::max(a.column, b.column), row = std::max(a.row, b.row);
    const int end_column = std::min(a.column + a.width, b.column + b.width);
    const int end_row = std::min(a.row + a.height, b.row + b.height);
    return {column, row, std::max(0, end_column - column), std::max(0, end_row - row)};
}

} // namespace sr::render
