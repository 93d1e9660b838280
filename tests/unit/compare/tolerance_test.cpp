#include "compare/compare.hpp"
#include "core/error.hpp"
#include "support/address.hpp"

#include <algorithm>

using namespace sr::compare;
using sr::image::Image;
using sr::testing::Test;

namespace {

std::string refusal(const std::string& expression) {
    try {
        parse_tolerance(expression);
        return {};
    } catch (const sr::Error& error) {
        return error.what();
    }
}

const Test parses("unit.golden.tolerance.parses", [] {
    const Tolerance rel = parse_tolerance("rel=0.02@99.5%");
    EXPECT_EQ(rel.measure, Measure::rel);
    EXPECT_DOUBLE_EQ(rel.limit, 0.02);
    EXPECT_DOUBLE_EQ(rel.quantile, 0.995);
    EXPECT_TRUE(rel.by_pixel);
    EXPECT_EQ(rel.text, "rel=0.02@99.5%");
    EXPECT_FALSE(parse_tolerance("flip=0.03").by_pixel);
    EXPECT_TRUE(parse_tolerance("flip=0.03@99%").by_pixel);
    EXPECT_DOUBLE_EQ(parse_tolerance("abs=1e-3").quantile, 1.0);
    EXPECT_DOUBLE_EQ(parse_tolerance("z=auto").limit, 0.0);
});

const Test names_what_is_wrong("unit.golden.tolerance.names_what_is_wrong", [] {
    EXPECT_NE(refusal("0.02").find("no ="), std::string::npos);
    EXPECT_NE(refusal("psnr=40").find("'psnr' is none of rel, abs,"), std::string::npos);
    EXPECT_NE(refusal("rel=").find("'' is not a number"), std::string::npos);
    EXPECT_NE(refusal("rel=-1").find("'-1' is not a number"), std::string::npos);
    EXPECT_NE(refusal("rel=nan").find("is not a number"), std::string::npos);
    EXPECT_NE(refusal("rel=0.02@99").find("ends in %"), std::string::npos);
    EXPECT_NE(refusal("rel=0.02@0%").find("between 0 and 100"), std::string::npos);
    EXPECT_NE(refusal("rmse=1@50%").find("one number for the image"), std::string::npos);
    EXPECT_NE(refusal("ssim=2").find("at most 1"), std::string::npos);
    EXPECT_NE(refusal("z=0").find("z=0"), std::string::npos);
});

/// Equal grey images of 20 × 10 pixels, of which `wrong` differ by 50 %.
Comparison with_wrong_pixels(int wrong, const std::string& expression) {
    Image reference(20, 10, 3);
    std::ranges::fill(reference.pixels, 2.0f);
    Image test = reference;
    for (int i = 0; i < wrong; ++i)
        for (float& value : test.at(2 * (i % 10), 2 * (i / 10))) value = 3.0f;
    CompareOptions options;
    options.tolerances = {parse_tolerance(expression), parse_tolerance("density=1")};
    return compare(test, reference, options);
}

// 98 % of 200 pixels are 196: four may fail, a fifth not.
const Test counts_pixels("unit.golden.tolerance.counts_pixels", [] {
    EXPECT_TRUE(with_wrong_pixels(4, "rel=0.4@98%").passed);
    EXPECT_FALSE(with_wrong_pixels(5, "rel=0.4@98%").passed);
    EXPECT_TRUE(with_wrong_pixels(5, "rel=0.51@98%").passed);
    EXPECT_FALSE(with_wrong_pixels(1, "abs=0.9").passed);
    EXPECT_TRUE(with_wrong_pixels(1, "abs=1").passed);
});

const Test means_and_sums("unit.golden.tolerance.means_and_sums", [] {
    const Metrics metrics = with_wrong_pixels(8, "rel=1").metrics; // 8 of 200 are 3 instead of 2
    EXPECT_DOUBLE_EQ(metrics.max_abs, 1.0);
    EXPECT_DOUBLE_EQ(metrics.mean_abs, 0.04);
    EXPECT_DOUBLE_EQ(metrics.max_rel, 0.5);
    EXPECT_DOUBLE_EQ(metrics.mean_rel, 0.02);
    EXPECT_DOUBLE_EQ(metrics.rmse, 0.2);
    EXPECT_DOUBLE_EQ(metrics.floor, static_cast<double>(0.01 * 2.0f));
    EXPECT_NEAR(metrics.rel_mse, 0.04 / (4.0 + 4e-4), 1e-12);
    for (const double ratio : metrics.energy_ratio) EXPECT_DOUBLE_EQ(ratio, 1.02);
    EXPECT_TRUE(with_wrong_pixels(8, "energy=0.021").passed);
    EXPECT_FALSE(with_wrong_pixels(8, "energy=0.019").passed);
    EXPECT_TRUE(with_wrong_pixels(8, "rmse=0.21").passed);
    EXPECT_FALSE(with_wrong_pixels(8, "rmse=0.19").passed);
    EXPECT_FALSE(with_wrong_pixels(50, "ssim=0.999").passed);
});

// 81 wrong pixels, once scattered over 64 × 64, once in a block: the same share, another density.
const Test density_tells_regions("unit.golden.tolerance.density_tells_regions", [] {
    Image reference(64, 64, 3);
    std::ranges::fill(reference.pixels, 2.0f);
    Image scattered = reference, clustered = reference;
    for (int i = 0; i < 81; ++i) {
        scattered.at(7 * (i % 9), 7 * (i / 9))[1] = 3.0f;
        clustered.at(20 + i % 9, 30 + i / 9)[1] = 3.0f;
    }
    CompareOptions options;
    options.tolerances = {parse_tolerance("rel=0.02@98%")};
    const Comparison speckle = compare(scattered, reference, options),
                     region = compare(clustered, reference, options);
    EXPECT_TRUE(speckle.passed);
    EXPECT_FALSE(region.passed);
    EXPECT_DOUBLE_EQ(speckle.metrics.failing_fraction, region.metrics.failing_fraction);
    EXPECT_DOUBLE_EQ(region.metrics.density, 81.0 / 256.0);
    EXPECT_LE(speckle.metrics.density, 9.0 / 256.0);
});

} // namespace
