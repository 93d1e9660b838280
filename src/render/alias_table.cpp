#include "render/alias_table.hpp"

#include <numeric>

namespace sr::render {

// Triangles of equal areas make shares of 1 but for the rounding of their corners, some 1e-6. All of them
// count as full, so that the table, and with it every sample, stays the same when a scene is moved or scaled.
// The error of a triangle's probability is below 1e-5.
constexpr double full_share = 1.0 - 1e-5;

std::vector<AliasEntry> alias_table(std::span<const double> weights) {
    const std::size_t count = weights.size();
    const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::vector<AliasEntry> table(count);
    std::vector<double> share(count, 1.0); // of the mean
    std::vector<std::size_t> small, large;
    for (std::size_t i = 0; i < count; ++i) {
        if (total > 0.0) share[i] = weights[i] / total * static_cast<double>(count);
        table[i].probability = static_cast<float>(share[i] / static_cast<double>(count));
        table[i].alias = static_cast<int>(i);
        (share[i] < full_share ? small : large).push_back(i);
    }
    while (!small.empty() && !large.empty()) {
        const std::size_t needy = small.back(), rich = large.back();
        small.pop_back();
        table[needy].keep = static_cast<float>(share[needy]);
        table[needy].alias = static_cast<int>(rich);
        share[rich] -= 1.0 - share[needy];
        if (share[rich] < full_share) {
            large.pop_back();
            small.push_back(rich);
        }
    }
    return table; // what is left over is full but for rounding, and keeps its share
}

} // namespace sr::render
