#pragma once
// Pixels at edges that fall to the other side, as two drivers differ.
#include "golden_mutants/change.hpp"

#include <cmath>
#include <set>

namespace sr::testing {

/// Pixels at edges that fall to the other side: `count` of them, none beside another, take a neighbour's
/// value, or a share of it where only some of a pixel's samples fall.
inline void flip_edges(image::Image& image, int count, std::uint32_t seed, float share = 1.0f) {
    const image::Image right = image;
    Random random(seed);
    std::set<std::pair<int, int>> used;
    for (int tries = 0; tries < 400000 && static_cast<int>(used.size()) < count; ++tries) {
        const int x = 2 + static_cast<int>(random.uniform() * static_cast<float>(image.width - 4));
        const int y = 2 + static_cast<int>(random.uniform() * static_cast<float>(image.height - 4));
        const bool is_beside = std::ranges::any_of(
            used, [&](const auto& p) { return std::abs(p.first - x) <= 1 && std::abs(p.second - y) <= 1; });
        const auto here = right.at(x, y), beside = right.at(x + 1, y), behind = right.at(x - 1, y);
        // An edge between two even sides: equal along it, and different across.
        const auto is_like = [](auto a, auto b) {
            return std::abs(a[1] - b[1]) <= 0.05f * std::max(a[1], b[1]);
        };
        if (is_beside || is_like(here, beside) || !is_like(here, behind)) continue;
        if (!is_like(here, right.at(x, y - 1)) || !is_like(here, right.at(x, y + 1))) continue;
        if (!is_like(beside, right.at(x + 1, y - 1)) || !is_like(beside, right.at(x + 2, y))) continue;
        const auto to = image.at(x, y);
        for (std::size_t c = 0; c < to.size(); ++c) to[c] += share * (beside[c] - to[c]);
        used.insert({x, y});
    }
}

/// Rows as columns, with the names of the channels.
inline image::Image transposed(const image::Image& image) {
    image::Image result(image.height, image.width, image.channels);
    result.channel_names = image.channel_names;
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) std::ranges::copy(image.at(y, x), result.at(x, y).begin());
    return result;
}

/// The same along rows: the edges are horizontal.
inline void flip_edges_along_rows(image::Image& image, int count, std::uint32_t seed) {
    image::Image turned = transposed(image);
    flip_edges(turned, count, seed);
    image = transposed(turned);
}

} // namespace sr::testing
