// Statistics of pixels: extremes, means, deviation, histogram; what is not finite counts apart.
#include "support/address.hpp"
#include "viewer/document/pixel_statistics.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

using namespace sr::viewer;
using sr::testing::Test;

namespace {

/// Greys 1, 10, 100 and 1000 in a row, below which stand a black, a red and two that are not finite.
sr::image::Image film() {
    sr::image::Image image(4, 2, 4);
    float grey = 1.0f;
    for (int x = 0; x < 4; ++x, grey *= 10.0f) std::ranges::fill(image.at(x, 0), grey);
    image.at(1, 1)[0] = 2.0f;
    image.at(2, 1)[1] = std::numeric_limits<float>::infinity();
    image.at(3, 1)[2] = std::numeric_limits<float>::quiet_NaN();
    return image;
}

const Test rectangles("unit.viewer.statistics.of_a_rectangle", [] {
    const PixelStatistics row = statistics_of(film(), {{0, 0}, {4, 1}});
    EXPECT_EQ(row.count, 4u);
    EXPECT_EQ(row.not_finite, 0u);
    EXPECT_NEAR(row.mean.x, 277.75, 1e-9);
    EXPECT_NEAR(row.mean.w, 277.75, 1e-3) << "the luminance of a grey";
    EXPECT_EQ(row.min.y, 1.0);
    EXPECT_EQ(row.max.z, 1000.0);
    EXPECT_NEAR(row.deviation, 418.784178, 1e-3);
    EXPECT_EQ(row.first, 0.0);
    EXPECT_EQ(row.last, 3.0);
    for (const std::size_t bin : {0u, 63u}) EXPECT_EQ(row.histogram[bin], 1u) << bin;
    EXPECT_EQ(std::accumulate(row.histogram.begin(), row.histogram.end(), std::size_t{0}), 4u);
    const PixelStatistics all = statistics_of(film(), {{0, 0}, {4, 2}});
    EXPECT_EQ(all.count, 6u);
    EXPECT_EQ(all.not_finite, 2u);
    EXPECT_EQ(all.max.x, 1000.0);
    EXPECT_NEAR(all.min.w, 0.0, 0.0);
    EXPECT_EQ(statistics_of(film(), {{2, 1}, {4, 2}}).count, 0u);
});

const Test corners("unit.viewer.statistics.a_rectangle_has_both_corners", [] {
    const PixelRectangle here{{1, 2}, {4, 6}};
    EXPECT_EQ(between({1, 2}, {3, 5}, {10, 10}), here);
    EXPECT_EQ(between({3, 2}, {1, 5}, {10, 10}), here) << "in any order";
    EXPECT_EQ(between({-5, 2}, {30, 5}, {10, 4}), (PixelRectangle{{0, 2}, {10, 4}})) << "within the picture";
});

} // namespace
