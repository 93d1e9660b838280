#include "compare/edges.hpp"

#include "compare/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace sr::compare {
namespace {

/// Calls `visit` with each pixel around the given one that lies inside the image.
template<typename Visit>
void for_each_neighbour(const AlignedImages& images, std::size_t pixel, const Visit& visit) {
    const int width = images.reference.width, height = images.reference.height;
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
            if (u != x || v != y) visit(static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + u);
}

using PixelAt = std::span<const float> (AlignedImages::*)(std::size_t) const;

/// True if every channel of `values` lies within the 3×3 pixels of an image, or within the slack of them, or
/// within `share` of the pixel's change.
bool is_within_neighbours(const AlignedImages& images, std::size_t pixel, std::span<const float> values,
                          PixelAt at, const Slack& slack, float share) {
    for (std::size_t c = 0; c < values.size(); ++c) {
        float low = (images.*at)(pixel)[c], high = low;
        for_each_neighbour(images, pixel, [&](std::size_t i) {
            low = std::min(low, (images.*at)(i)[c]);
            high = std::max(high, (images.*at)(i)[c]);
        });
        const float change = share * std::abs(images.test_at(pixel)[c] - images.reference_at(pixel)[c]);
        if (values[c] < low - std::max(slack(pixel, c, low), change)
            || values[c] > high + std::max(slack(pixel, c, high), change))
            return false;
    }
    return true;
}

float distance(std::span<const float> a, std::span<const float> b) {
    float sum = 0.0f;
    for (std::size_t c = 0; c < a.size(); ++c) sum += std::abs(a[c] - b[c]);
    return sum;
}

/// True if at least `count` neighbours in the reference resemble the old value and as many the new one.
bool has_two_sides(const AlignedImages& images, std::size_t pixel, int count) {
    int like_old = 0, like_new = 0;
    for_each_neighbour(images, pixel, [&](std::size_t i) {
        const float from_old = distance(images.reference_at(i), images.reference_at(pixel)),
                    from_new = distance(images.reference_at(i), images.test_at(pixel));
        like_old += from_old <= from_new;
        like_new += from_new <= from_old;
    });
    return like_old >= count && like_new >= count;
}

/// The failing pixels that touch the given one, directly or through one another, with itself.
std::vector<std::size_t> cluster_of(const AlignedImages& images, std::size_t pixel,
                                    const std::unordered_set<std::size_t>& failing) {
    std::vector<std::size_t> cluster{pixel};
    for (std::size_t k = 0; k < cluster.size() && cluster.size() <= max_edge_cluster; ++k)
        for_each_neighbour(images, cluster[k], [&](std::size_t i) {
            if (failing.contains(i) && std::ranges::find(cluster, i) == cluster.end()) cluster.push_back(i);
        });
    return cluster;
}

bool is_explained(const AlignedImages& images, std::size_t pixel,
                  const std::unordered_set<std::size_t>& failing, const Slack& slack) {
    const std::size_t cluster = cluster_of(images, pixel, failing).size();
    return cluster <= max_edge_cluster && has_two_sides(images, pixel, cluster == 1 ? 2 : 3)
           && is_within_neighbours(images, pixel, images.test_at(pixel), &AlignedImages::reference_at, slack,
                                   0.0f)
           && is_within_neighbours(images, pixel, images.reference_at(pixel), &AlignedImages::test_at, slack,
                                   max_lost_share);
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
    const double window =
        std::min(density_window, images.reference.width) * std::min(density_window, images.reference.height);
    judgement.is_crowded = densest_window(images, fails) * window > max_at_edges_nearby + 0.5;
    return judgement;
}

} // namespace sr::compare
