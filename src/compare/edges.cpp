#include "compare/edges.hpp"

#include "compare/arrangement.hpp"
#include "compare/metrics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_set>

namespace sr::compare {
namespace {

struct Offset {
    int x = 0;
    int y = 0;
};

/// The 8 neighbours, once around.
constexpr std::array<Offset, 8> circle{
    {{-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}}};

/// The pixel beside the given one, if it lies inside the image and is compared.
std::optional<std::size_t> beside(const AlignedImages& images, std::size_t pixel, Offset offset) {
    const int width = images.reference.width;
    const int x = static_cast<int>(pixel) % width + offset.x, y = static_cast<int>(pixel) / width + offset.y;
    if (x < 0 || y < 0 || x >= width || y >= images.reference.height) return std::nullopt;
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x;
    return images.pixels[at] == PixelState::compared ? std::optional(at) : std::nullopt;
}

/// Calls `visit` with each neighbour that is compared.
template<typename Visit>
void for_each_neighbour(const AlignedImages& images, std::size_t pixel, const Visit& visit) {
    for (const Offset offset : circle)
        if (const auto at = beside(images, pixel, offset)) visit(*at);
}

using PixelAt = std::span<const float> (AlignedImages::*)(std::size_t) const;

/// True if every channel of `values` lies within the 3×3 pixels of an image, or within the slack of them, or
/// within the margin that its change in that channel allows.
template<typename Margin>
bool is_within_neighbours(const AlignedImages& images, std::size_t pixel, std::span<const float> values,
                          PixelAt at, const Slack& slack, const Margin& margin) {
    for (std::size_t c = 0; c < values.size(); ++c) {
        float low = (images.*at)(pixel)[c], high = low;
        for_each_neighbour(images, pixel, [&](std::size_t i) {
            low = std::min(low, (images.*at)(i)[c]);
            high = std::max(high, (images.*at)(i)[c]);
        });
        const float change = margin(std::abs(images.test_at(pixel)[c] - images.reference_at(pixel)[c]));
        if (values[c] < low - std::max(slack(pixel, c, low), change)
            || values[c] > high + std::max(slack(pixel, c, high), change))
            return false;
    }
    return true;
}

/// The change of the channel that changed most.
float largest_change(const AlignedImages& images, std::size_t pixel) {
    float largest = 0.0f;
    for (std::size_t c = 0; c < images.reference_at(pixel).size(); ++c)
        largest = std::max(largest, std::abs(images.test_at(pixel)[c] - images.reference_at(pixel)[c]));
    return largest;
}

float distance(std::span<const float> a, std::span<const float> b) {
    float sum = 0.0f;
    for (std::size_t c = 0; c < a.size(); ++c) sum += std::abs(a[c] - b[c]);
    return sum;
}

enum class Side { none, old_value, new_value };

/// The side whose value, of the pixel's two, these values resemble more.
Side side_of(const AlignedImages& images, std::size_t pixel, std::span<const float> values) {
    return distance(values, images.reference_at(pixel)) <= distance(values, images.test_at(pixel))
               ? Side::old_value
               : Side::new_value;
}

/// Gives a corner of the circle to the side of both pixels beside it: it touches the middle at a point only,
/// and another surface may begin there.
void settle_corners(std::array<Side, 8>& sides) {
    for (std::size_t k = 0; k < 8; k += 2) {
        const Side before = sides[(k + 7) % 8], after = sides[k + 1];
        if (before == after && before != Side::none && sides[k] != Side::none) sides[k] = before;
    }
}

/// True if the neighbours on one side are one arc of the circle, long enough.
bool is_one_arc(const std::array<Side, 8>& sides, Side side, int min_length) {
    int arcs = 0;
    for (std::size_t k = 0; k < 8; ++k) arcs += sides[k] == side && sides[(k + 7) % 8] != side;
    return arcs == 1 && std::ranges::count(sides, side) >= min_length;
}

/// True if the neighbours that resemble the old value, and those that resemble the new one, are an arc each.
bool has_two_sides(const AlignedImages& images, std::size_t pixel, PixelAt at, int min_length) {
    std::array<Side, 8> sides{};
    for (std::size_t k = 0; k < 8; ++k) {
        const auto i = beside(images, pixel, circle[k]);
        if (i) sides[k] = side_of(images, pixel, (images.*at)(*i));
    }
    settle_corners(sides);
    return is_one_arc(sides, Side::old_value, min_length) && is_one_arc(sides, Side::new_value, min_length);
}

/// True if the pixels of the reference that resemble the old value, and hang together with a neighbour in a
/// window around the pixel, are a surface without the pixel itself.
bool is_old_side_surface(const AlignedImages& images, std::size_t pixel) {
    constexpr int reach = surface_window / 2, edge = surface_window, middle = edge * reach + reach;
    std::array<bool, static_cast<std::size_t>(edge) * edge> is_free{}; // on this side, and not yet counted
    for (int k = 0; k < edge * edge; ++k)
        if (const auto i = beside(images, pixel, {k % edge - reach, k / edge - reach}); i && k != middle)
            is_free[static_cast<std::size_t>(k)] =
                side_of(images, pixel, images.reference_at(*i)) == Side::old_value;
    std::vector<int> found;
    const auto visit = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= edge || y >= edge || !is_free[static_cast<std::size_t>(y * edge + x)])
            return;
        is_free[static_cast<std::size_t>(y * edge + x)] = false;
        found.push_back(y * edge + x);
    };
    for (const Offset offset : circle) visit(reach + offset.x, reach + offset.y);
    for (std::size_t k = 0; k < found.size() && found.size() < min_surface; ++k)
        for (const Offset offset : circle) visit(found[k] % edge + offset.x, found[k] / edge + offset.y);
    return found.size() >= min_surface;
}

/// The median distance of adjacent pixels in a window of the reference around the pixel: edges are too few to
/// move it.
float grain_around(const AlignedImages& images, std::size_t pixel) {
    constexpr int reach = surface_window / 2;
    std::vector<float> distances;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const auto here = beside(images, pixel, {x, y});
            for (const Offset next : {Offset{x + 1, y}, Offset{x, y + 1}})
                if (const auto there = beside(images, pixel, next); here && there)
                    distances.push_back(distance(images.reference_at(*here), images.reference_at(*there)));
        }
    if (distances.empty()) return 0.0f;
    const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::ranges::nth_element(distances, median);
    return *median;
}

/// True if the pixel changed by no more than its neighbours differ, and by little.
bool is_lost_in_grain(const AlignedImages& images, std::size_t pixel, const Slack& slack) {
    const auto before = images.reference_at(pixel), after = images.test_at(pixel);
    for (std::size_t c = 0; c < before.size(); ++c)
        if (std::abs(after[c] - before[c]) > max_grain_limits * slack(pixel, c, before[c])) return false;
    return distance(before, after) <= max_grain * grain_around(images, pixel);
}

/// True if the pixel changed by little, and no more than a picture moved by the rounding of places changes
/// there.
bool is_lost_in_slope(const AlignedImages& images, std::size_t pixel, const Slack& slack) {
    const auto before = images.reference_at(pixel), after = images.test_at(pixel);
    for (std::size_t c = 0; c < before.size(); ++c) {
        float low = before[c], high = low;
        for_each_neighbour(images, pixel, [&](std::size_t i) {
            low = std::min(low, images.reference_at(i)[c]);
            high = std::max(high, images.reference_at(i)[c]);
        });
        const float change = std::abs(after[c] - before[c]), limit = slack(pixel, c, before[c]);
        if (change > limit && change > std::min(max_slope_limits * limit, max_slope_share * (high - low)))
            return false;
    }
    return true;
}

/// The number of failing pixels that touch the given one, directly or through one another, with itself.
std::size_t cluster_of(const AlignedImages& images, std::size_t pixel,
                       const std::unordered_set<std::size_t>& failing) {
    std::vector<std::size_t> cluster{pixel};
    for (std::size_t k = 0; k < cluster.size() && cluster.size() <= max_edge_cluster; ++k)
        for_each_neighbour(images, cluster[k], [&](std::size_t i) {
            if (failing.contains(i) && std::ranges::find(cluster, i) == cluster.end()) cluster.push_back(i);
        });
    return cluster.size();
}

bool is_explained(const AlignedImages& images, std::size_t pixel,
                  const std::unordered_set<std::size_t>& failing, const Slack& slack) {
    const std::size_t cluster = cluster_of(images, pixel, failing);
    const int min_length = cluster == 1 ? 2 : 3;
    if (cluster > max_edge_cluster) return false;
    if (is_lost_in_slope(images, pixel, slack)) return true;
    const float overshoot = max_overshoot * largest_change(images, pixel);
    const bool nothing_appeared =
        is_within_neighbours(images, pixel, images.test_at(pixel), &AlignedImages::reference_at, slack,
                             [overshoot](float) { return overshoot; });
    if (is_lost_in_grain(images, pixel, slack)) return nothing_appeared;
    const auto is_at_edge = [&] {
        return has_two_sides(images, pixel, &AlignedImages::reference_at, min_length)
               && has_two_sides(images, pixel, &AlignedImages::test_at, min_length)
               && is_old_side_surface(images, pixel);
    };
    return nothing_appeared && is_at_edge()
           && is_within_neighbours(images, pixel, images.reference_at(pixel), &AlignedImages::test_at, slack,
                                   [](float change) { return max_lost_share * change; });
}

/// The third quartile of the differences in a column, or in a row; 0 beside the image.
float change_of_line(const AlignedImages& images, int line, bool is_column) {
    const int width = images.reference.width, height = images.reference.height;
    if (line < 0 || line >= (is_column ? width : height)) return 0.0f;
    std::vector<float> changes;
    for (int k = 0; k < (is_column ? height : width); ++k) {
        const auto i = static_cast<std::size_t>(is_column ? k * width + line : line * width + k);
        if (images.pixels[i] == PixelState::compared)
            changes.push_back(distance(images.test_at(i), images.reference_at(i)));
    }
    if (changes.empty()) return 0.0f;
    const auto quartile = changes.begin() + static_cast<std::ptrdiff_t>(changes.size() * 3 / 4);
    std::ranges::nth_element(changes, quartile);
    return *quartile;
}

/// True if a row or a column of several failing pixels changed along its length, unlike those beside it: a
/// line that is repeated or moved.
bool is_a_line_wrong(const AlignedImages& images, const std::unordered_set<std::size_t>& failing) {
    const auto width = static_cast<std::size_t>(images.reference.width);
    for (const bool is_column : {true, false}) {
        std::map<std::size_t, std::size_t> counts;
        for (const std::size_t i : failing) ++counts[is_column ? i % width : i / width];
        for (const auto& [place, count] : counts) {
            if (count < min_in_wrong_line) continue;
            const int line = static_cast<int>(place);
            const float beside = std::max(change_of_line(images, line - 1, is_column),
                                          change_of_line(images, line + 1, is_column));
            if (change_of_line(images, line, is_column) > wrong_line_ratio * beside) return true;
        }
    }
    return false;
}

} // namespace

EdgeJudgement judge_edges(const AlignedImages& images, const std::vector<bool>& fails, const Slack& slack) {
    EdgeJudgement judgement;
    judgement.failing = static_cast<std::size_t>(std::ranges::count(fails, true));
    judgement.max_count =
        std::min(max_at_edges,
                 static_cast<std::size_t>(max_share_at_edges * static_cast<double>(fails.size()) + 1e-9));
    judgement.unexplained = judgement.failing;
    if (judgement.failing == 0 || judgement.failing > judgement.max_count) return judgement;
    std::unordered_set<std::size_t> failing;
    for (std::size_t k = 0; k < fails.size(); ++k)
        if (fails[k]) failing.insert(images.compared[k]);
    judgement.unexplained = static_cast<std::size_t>(std::ranges::count_if(
        failing, [&](std::size_t pixel) { return !is_explained(images, pixel, failing, slack); }));
    judgement.is_crowded = densest_window(images, fails, edge_window).most > max_at_edges_nearby;
    const auto width = static_cast<std::size_t>(images.reference.width);
    judgement.is_in_line = are_in_line(failing, width);
    judgement.is_in_rectangle = are_in_rectangle(failing, width);
    judgement.is_line_wrong = is_a_line_wrong(images, failing);
    return judgement;
}

} // namespace sr::compare
