#include "render/adaptive/allocation.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace sr::render {
namespace {

/// The part of the target that is aimed at, since estimates change until the end.
constexpr double aimed_share = 0.9;

/// The side of the blocks of pixels that are frozen together: enough to tell an error by, few enough to
/// follow a penumbra.
constexpr int block_side = 4;

/// A picture of blocks.
struct Blocks {
    int columns = 0;
    int rows = 0;
    std::vector<float> values;

    Blocks(int width, int height)
        : columns((width + block_side - 1) / block_side),
          rows((height + block_side - 1) / block_side),
          values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0.0f) {}

    float& at(int column, int row) { return values[index(column, row)]; }
    float at(int column, int row) const { return values[index(column, row)]; }

private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns)
               + static_cast<std::size_t>(column);
    }
};

/// The mean square of each block.
Blocks block_squares(const ErrorEstimate& estimate) {
    Blocks sums(estimate.width, estimate.height);
    std::size_t i = 0;
    for (int y = 0; y < estimate.height; ++y)
        for (int x = 0; x < estimate.width; ++x)
            sums.at(x / block_side, y / block_side) += estimate.squares[i++];
    for (int row = 0; row < sums.rows; ++row) {
        for (int column = 0; column < sums.columns; ++column) {
            const int width = std::min(block_side, estimate.width - column * block_side);
            const int height = std::min(block_side, estimate.height - row * block_side);
            sums.at(column, row) /= static_cast<float>(width * height);
        }
    }
    return sums;
}

/// The largest value of each block and the eight around it.
Blocks with_surroundings(Blocks blocks) {
    Blocks largest = blocks;
    for (int row = 0; row < blocks.rows; ++row) {
        for (int column = 0; column < blocks.columns; ++column) {
            for (int y = std::max(0, row - 1); y <= std::min(blocks.rows - 1, row + 1); ++y)
                for (int x = std::max(0, column - 1); x <= std::min(blocks.columns - 1, column + 1); ++x)
                    largest.at(column, row) = std::max(largest.at(column, row), blocks.at(x, y));
        }
    }
    return largest;
}

/// Calls `visit(i, square)` for each pixel, with the square of its block.
template<typename Visit>
void for_each_pixel(const ErrorEstimate& estimate, const Blocks& squares, const Visit& visit) {
    std::size_t i = 0;
    for (int y = 0; y < estimate.height; ++y)
        for (int x = 0; x < estimate.width; ++x, ++i) visit(i, squares.at(x / block_side, y / block_side));
}

/// The error at the end, if pixels whose squares are over the level go on until it has risen to them. With k
/// times the samples a square is 1/k of itself and the level k of itself, so they meet at k =
/// √(square/level).
double error_at_end(ErrorEstimate estimate, const Blocks& squares, const std::vector<bool>& works,
                    float level) {
    for_each_pixel(estimate, squares, [&](std::size_t i, float square) {
        if (works[i] && square > level) estimate.squares[i] *= std::sqrt(level / square);
    });
    sum_up(estimate);
    return estimate.error;
}

/// The highest level that leads to the target, to a factor of √2; 0 if none does.
float level_for(const ErrorEstimate& estimate, const Blocks& squares, const std::vector<bool>& works,
                double target) {
    const float largest = *std::ranges::max_element(squares.values);
    const auto level = [&](int step) { return largest * std::exp2(-0.5f * static_cast<float>(step)); };
    const auto steps = std::views::iota(0, 64);
    const auto first = std::ranges::partition_point(steps, [&](int step) {
        return error_at_end(estimate, squares, works, level(step)) > aimed_share * target;
    });
    return first == steps.end() ? 0.0f : level(*first);
}

} // namespace

PixelMask with_enough_samples(const ErrorEstimate& estimate, const std::vector<int>& samples, int count,
                              double target) {
    std::vector<bool> works;
    works.reserve(samples.size());
    for (const int taken : samples) works.push_back(taken == count);
    const Blocks squares = with_surroundings(block_squares(estimate));
    const float level = level_for(estimate, squares, works, target);
    PixelMask enough(samples.size());
    for_each_pixel(estimate, squares,
                   [&](std::size_t i, float square) { enough[i] = !works[i] || square <= level ? 1 : 0; });
    return enough;
}

} // namespace sr::render
