#include "render/adaptive/allocation.hpp"

#include "support/address.hpp"

#include <cmath>

using namespace sr;

namespace {

constexpr int side = 64; // pixels

/// A picture whose left half has pixels of this square, and whose right half has others.
struct Picture {
    std::vector<int> samples = std::vector<int>(side * side, 64);
    render::ErrorEstimate estimate;

    Picture(float left, float right) {
        estimate.width = estimate.height = side;
        for (int i = 0; i < side * side; ++i) estimate.squares.push_back(i % side < side / 2 ? left : right);
        render::sum_up(estimate);
    }

    /// Doubles the samples of the pixels that have not enough of them, which halves their squares.
    void go_on(const render::PixelMask& enough) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (enough[i] != 0) continue;
            samples[i] *= 2;
            estimate.squares[i] *= 0.5f;
        }
        render::sum_up(estimate);
    }
};

int stopped(const render::PixelMask& enough) {
    int count = 0;
    for (const std::uint8_t each : enough) count += each != 0;
    return count;
}

// Noise of eight times the deviation gets eight times the samples, to the factor of two by which they grow.
const sr::testing::Test by_noise("unit.render.allocation.samples_go_with_the_deviation", [] {
    Picture picture(1e-4f, 64e-4f);
    constexpr double target = 0.008;
    int count = 64;
    while (picture.estimate.error > target && count < 1 << 20) {
        picture.go_on(render::with_enough_samples(picture.estimate, picture.samples, count, target));
        count *= 2;
    }
    const double quiet = picture.samples[0], noisy = picture.samples[side - 1];
    EXPECT_NEAR(std::log2(noisy / quiet), 3.0, 1.0) << quiet << " and " << noisy;
    EXPECT_LE(picture.estimate.error, target);
    EXPECT_GT(picture.estimate.error, 0.5 * target);
});

// Where all are alike, none stops before the target is met, and all do then.
const sr::testing::Test alike("unit.render.allocation.equal_pixels_stop_together", [] {
    const Picture picture(1e-3f, 1e-3f);
    const double error = picture.estimate.error;
    const auto stopped_for = [&](double target) {
        return stopped(render::with_enough_samples(picture.estimate, picture.samples, 64, target));
    };
    EXPECT_EQ(stopped_for(0.9 * error), 0);
    EXPECT_EQ(stopped_for(1.2 * error), side * side);
});

// Those that have stopped are not woken. If they leave too much, all others go on.
const sr::testing::Test asleep("unit.render.allocation.what_has_stopped_stays", [] {
    Picture picture(1e-3f, 1e-5f);
    for (int i = 0; i < side * side; ++i)
        if (i % side < side / 2) picture.samples[static_cast<std::size_t>(i)] = 32;
    const render::PixelMask enough =
        render::with_enough_samples(picture.estimate, picture.samples, 64, 0.001);
    EXPECT_EQ(stopped(enough), side * side / 2);
    EXPECT_EQ(enough[0], 1);
    EXPECT_EQ(enough[side - 1], 0);
});

// An edge may enter the next block with the next sample, so that the blocks beside a noisy one go on with it.
const sr::testing::Test around("unit.render.allocation.blocks_beside_noise_go_on", [] {
    Picture picture(1e-6f, 1e-6f);
    picture.estimate.squares[side * 33 + 33] = 1.0f;
    render::sum_up(picture.estimate);
    const render::PixelMask enough = render::with_enough_samples(picture.estimate, picture.samples, 64, 0.01);
    EXPECT_EQ(side * side - stopped(enough), 12 * 12);
    EXPECT_EQ(enough[side * 28 + 28], 0);
    EXPECT_EQ(enough[side * 27 + 28], 1);
});

} // namespace
