#include "render/adaptive/convergence.hpp"

#include "support/address.hpp"

#include <vector>

using namespace sr;
using sr::testing::Test;

namespace {

// More of them break the promise of an error more often: tools/bench/results/error.md.
const Test due("unit.render.convergence.estimates_come_twice_while_samples_double", [] {
    std::vector<int> due;
    for (int samples = 0; samples <= 2048; ++samples)
        if (render::is_estimate_due(samples)) due.push_back(samples);
    EXPECT_EQ(due, (std::vector<int>{8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536,
                                     2048}));
});

} // namespace
