// The pixels and channels that are compared, and the messages for images that cannot be.
#include "compare/align.hpp"
#include "compare/compare.hpp"
#include "compare/moderated.hpp"
#include "compare/noise.hpp"
#include "compare/noise_of_seeds.hpp"
#include "compare/pictures.hpp"
#include "compare/rare_events.hpp"
#include "compare/winsorised.hpp"
#include "core/error.hpp"
#include "image/colormap.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

using namespace sr::compare;
using sr::image::Image;
using sr::testing::Test;

namespace {

Image grey(int width, int height, int channels = 3, float value = 1.0f) {
    Image image(width, height, channels);
    std::ranges::fill(image.pixels, value);
    return image;
}

std::string error_of(const Image& test, const Image& reference, const CompareOptions& options) {
    try {
        compare(test, reference, options);
        return {};
    } catch (const sr::Error& error) {
        return error.what();
    }
}

const Test sizes_differ("unit.golden.compare.sizes_differ", [] {
    const Comparison comparison = compare(grey(4, 3), grey(4, 4));
    EXPECT_FALSE(comparison.passed);
    ASSERT_EQ(comparison.verdicts.size(), 1u);
    EXPECT_NE(comparison.verdicts[0].line.find("4 x 3"), std::string::npos);
    EXPECT_EQ(comparison.metrics.pixels, 0u);
    EXPECT_TRUE(comparison.error.pixels.empty());
    EXPECT_EQ(heat_map(comparison).width, 1);
});

const Test bad_options("unit.golden.compare.bad_options", [] {
    const Image image = grey(8, 8);
    EXPECT_NE(error_of(image, image, {.region = PixelRegion{4, 4, 5, 1}}).find("not inside 8x8"),
              std::string::npos);
    EXPECT_NE(error_of(image, image, {.region = PixelRegion{4, 4, std::numeric_limits<int>::max(), 1}}), "");
    EXPECT_NE(error_of(image, image, {.mask = grey(8, 7)}).find("the mask is 8x7"), std::string::npos);
    EXPECT_NE(error_of(image, image, {.mask = grey(8, 8, 1, 0.0f)}).find("no pixel"), std::string::npos);
    EXPECT_NE(error_of(image, image, {.noise = {grey(7, 8)}}).find("the noise is 7x8"), std::string::npos);
    EXPECT_NE(error_of(image, image, {.noise = {grey(8, 8, 3, -1.0f)}}).find("negative"), std::string::npos);
    EXPECT_NE(error_of(image, image, {.layer = "key"}).find("no layer 'key'"), std::string::npos);
    EXPECT_NE(error_of(image, image, {.tolerances = {parse_tolerance("z=auto")}}).find("noise floor"),
              std::string::npos);
    EXPECT_NE(
        error_of(image, image,
                 {.tolerances = {parse_tolerance("hdr_flip=0.1")}, .encoding = Encoding::display_referred})
            .find("use flip"),
        std::string::npos);
});

const Test layers_alone("unit.golden.compare.layers_alone", [] {
    Image reference = grey(8, 8, 7);
    reference.channel_names = {"A", "B", "G", "R", "key.R", "key.G", "key.B"};
    Image test = reference;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) test.at(x, y)[5] = 2.0f; // key.G
    EXPECT_FALSE(compare(test, reference).passed);
    EXPECT_TRUE(compare(test, reference, {.other_layers = std::vector<std::string>{}}).passed);
    EXPECT_FALSE(compare(test, reference, {.other_layers = std::vector<std::string>{"key"}}).passed);
    EXPECT_FALSE(compare(test, reference, {.layer = "key"}).passed);
    EXPECT_EQ(layer_names(reference), std::vector<std::string>{"key"});
    EXPECT_EQ(layer_of(reference, "")->colors, (std::vector<int>{3, 2, 1}));
    EXPECT_EQ(layer_of(reference, "")->alpha, 0);
    EXPECT_EQ(layer_of(grey(1, 1, 1), "")->colors, std::vector<int>{0});
});

const Test error_map("unit.golden.compare.error_map", [] {
    const Image reference = grey(4, 1);
    Image test = reference;
    test.at(1, 0)[0] = 1.02f; // twice the limit
    test.at(2, 0)[2] = std::numeric_limits<float>::quiet_NaN();
    const Comparison comparison = compare(test, reference, {.region = PixelRegion{0, 0, 3, 1}});
    EXPECT_EQ(comparison.error.at(0, 0)[0], 0.0f);
    EXPECT_NEAR(comparison.error.at(1, 0)[0], 2.0f, 1e-4f);
    EXPECT_TRUE(std::isnan(comparison.error.at(2, 0)[0]));
    EXPECT_EQ(comparison.error.at(3, 0)[0], -1.0f);
    EXPECT_EQ(comparison.metrics.nonfinite_test, 1u);
    EXPECT_EQ(comparison.metrics.pixels, 2u);
});

const Test black_reference("unit.golden.compare.black_reference", [] {
    const Image black = grey(16, 16, 3, 0.0f);
    EXPECT_TRUE(compare(black, black).passed);
    const Comparison comparison = compare(grey(16, 16), black);
    EXPECT_FALSE(comparison.passed);
    EXPECT_TRUE(std::isinf(comparison.metrics.max_rel));
    EXPECT_FALSE(comparison.diagnosis.has_value());
});

const Test json_has_no_nan("unit.golden.compare.json_has_no_nan", [] {
    const auto json = json_of(compare(grey(16, 16), grey(16, 16, 3, 0.0f)));
    EXPECT_EQ(json["passed"], false);
    EXPECT_EQ(json["metrics"]["max_rel"], "inf");
    EXPECT_FALSE(json["metrics"].contains("max_z"));
    EXPECT_TRUE(json["diagnosis"].is_null());
    EXPECT_EQ(json.dump().find("null,null"), std::string::npos);
    const auto failing = json_of(compare(grey(16, 16, 3, 2.0f), grey(16, 16)));
    EXPECT_EQ(failing["diagnosis"]["name"], "factor_two");
});

// Standard normal quantiles: Abramowitz & Stegun 1964, Table 26.5 and 26.6.
const Test z_of_chance("unit.golden.noise.z_of_chance", [] {
    EXPECT_NEAR(two_sided_z(0.05), 1.959964, 1e-6);
    EXPECT_NEAR(two_sided_z(0.001), 3.290527, 1e-6);
    EXPECT_NEAR(two_sided_z(1e-9), 6.109410, 1e-5);
});

// Two-sided quantiles of Student's t: Abramowitz & Stegun 1964, Table 26.10.
const Test z_of_students_t("unit.golden.noise.z_of_students_t", [] {
    EXPECT_NEAR(z_of_t(2.201, 11.0), two_sided_z(0.05), 0.01);
    EXPECT_NEAR(z_of_t(4.437, 11.0), two_sided_z(0.001), 0.01);
    EXPECT_NEAR(z_of_t(12.706, 1.0), two_sided_z(0.05), 0.15);
    EXPECT_DOUBLE_EQ(z_of_t(3.0, 1e9), 3.0);
});

// Pictures that differ by one number everywhere: their blocks err as much as their pixels.
const Test errors_of_sums_are_measured("unit.golden.noise.errors_of_sums_are_measured", [] {
    NoiseOfSeeds noise;
    for (const float level : {1.0f, 2.0f, 3.0f}) noise.add(grey(32, 32, 3, level));
    const Image errors = noise.errors();
    EXPECT_EQ(errors.channel_names[3], "block.R");
    for (const float error : errors.at(20, 9)) EXPECT_FLOAT_EQ(error, 1.0f);
    EXPECT_TRUE(compare(grey(32, 32, 3, 2.9f), grey(32, 32, 3, 1.5f), {.noise = {errors}}).passed);
    EXPECT_THROW(noise.add(grey(31, 32)), sr::Error);
    EXPECT_THROW(NoiseOfSeeds().errors(), sr::Error);
});

// An edge on which all seeds agree: in another picture one of 16 samples may fall to its other side, two do
// not.
const Test unseen("unit.golden.noise.a_sample_may_cross_an_edge_that_no_seed_crossed", [] {
    const auto edge = [](float at_edge, const char* samples) {
        Image image = grey(32, 32, 3, 0.0f);
        for (int y = 0; y < 32; ++y)
            for (int x = 16; x < 32; ++x) std::ranges::fill(image.at(x, y), x == 16 ? at_edge : 1.0f);
        if (samples) image.attributes = {{"steradian:samples", samples}};
        return image;
    };
    for (const char* samples : {"16", static_cast<const char*>(nullptr)}) {
        NoiseOfSeeds noise;
        for (int i = 0; i < 12; ++i) noise.add(edge(0.5f, samples));
        const Image errors = noise.errors();
        const float floor = samples ? std::sqrt(13.0f) / 14.0f / 16.0f : 0.0f;
        EXPECT_NEAR(errors.at(16, 9)[0], floor, 1e-6f);
        EXPECT_NEAR(errors.at(15, 9)[0], 0.5f * floor, 1e-6f);
        EXPECT_EQ(errors.at(5, 9)[0], 0.0f);
        const auto passes = [&](float at_edge) {
            return compare(edge(at_edge, samples), edge(0.5f, samples), {.noise = {errors, errors}}).passed;
        };
        EXPECT_TRUE(passes(0.5f));
        EXPECT_EQ(passes(0.5f + 1.0f / 16.0f), samples != nullptr);
        EXPECT_FALSE(passes(1.0f));
    }
});

// Seeds of normal noise, and a picture in which some pixels, far from one another, are twice as bright.
const Test few_rare_events("unit.golden.noise.few_rare_events_are_left_out", [] {
    std::mt19937 random(7);
    std::normal_distribution<float> normal(1.0f, 0.02f);
    const auto seed = [&] {
        Image image = grey(96, 64);
        std::ranges::generate(image.pixels, [&] { return normal(random); });
        return image;
    };
    NoiseOfSeeds noise;
    for (int i = 0; i < 12; ++i) noise.add(seed());
    const CompareOptions options{.noise = {noise.errors(), noise.errors()}};
    const Image reference = seed(), test = seed();
    const auto passes = [&](int count, float value) {
        Image image = test;
        for (int i = 0; i < count; ++i) std::ranges::fill(image.at(7 + 4 * i, 5 + 11 * (i % 5)), value);
        return compare(image, reference, options).passed;
    };
    EXPECT_TRUE(passes(0, 2.0f));
    EXPECT_TRUE(passes(2, 2.0f));
    EXPECT_FALSE(passes(3, 2.0f));
    EXPECT_FALSE(passes(20, 2.0f));
    EXPECT_FALSE(passes(1, 5.0f)); // brighter than any sample of such a scene
    EXPECT_FALSE(passes(1, 0.0f)); // a hole
});

// In four pixels of one block a seed has a bright sample; the test has brighter ones, though within the limit
// of a pixel.
const Test rare_in_sums("unit.golden.noise.few_rare_events_decide_no_sum", [] {
    std::mt19937 random(9);
    std::normal_distribution<float> normal(1.0f, 0.02f);
    const auto seed = [&](int events, float value) {
        Image image = grey(96, 64);
        std::ranges::generate(image.pixels, [&] { return normal(random); });
        for (int i = 0; i < events; ++i) std::ranges::fill(image.at(18 + 4 * i, 20), value);
        return image;
    };
    NoiseOfSeeds noise;
    for (int i = 0; i < 12; ++i) noise.add(seed(i == 3 ? 4 : 0, 4.0f));
    const Image errors = noise.errors(), reference = seed(0, 1.0f);
    const auto passes = [&](const Image& test) {
        return compare(test, reference, {.noise = {errors, errors}}).passed;
    };
    for (int events = 0; events <= 3; ++events) EXPECT_TRUE(passes(seed(events, 16.0f))) << events;
    EXPECT_FALSE(passes(seed(4, 16.0f)));
    const auto brighter_block = [&](int left, int events) {
        Image image = seed(events, 16.0f);
        for (int y = 16; y < 32; ++y)
            for (int x = left; x < left + 16; ++x)
                for (float& value : image.at(x, y)) value += left == 16 ? 0.5f : 0.02f;
        return image;
    };
    EXPECT_FALSE(passes(brighter_block(16, 0))); // by less than the noise of the four
    EXPECT_FALSE(passes(brighter_block(32, 3)));
});

// All seeds cover all pixels; a sample of the test meets a crack here and there.
const Test rare_coverage("unit.golden.noise.rare_events_of_alpha_share_the_cap", [] {
    std::mt19937 random(8);
    std::normal_distribution<float> normal(1.0f, 0.02f);
    const auto seed = [&] {
        Image image = grey(96, 64, 4);
        image.channel_names = {"R", "G", "B", "A"};
        std::ranges::generate(image.pixels, [&] { return normal(random); });
        for (std::size_t p = 3; p < image.pixels.size(); p += 4) image.pixels[p] = 1.0f;
        return image;
    };
    NoiseOfSeeds noise;
    for (int i = 0; i < 12; ++i) noise.add(seed());
    const Image errors = noise.errors(), reference = seed(), test = seed();
    const auto passes = [&](int cracks, float alpha, int bright, bool is_there = false) {
        Image image = test;
        for (int i = 0; i < cracks; ++i) image.at(9 + 8 * i, 5 + 11 * (i % 5))[3] = alpha;
        for (int i = 0; i < bright; ++i)
            std::ranges::fill(image.at(9 + 8 * (i + (is_there ? 0 : 5)), 5 + 11 * (i % 5)).first(3), 2.0f);
        return compare(image, reference, {.noise = {errors, errors}}).passed;
    };
    EXPECT_TRUE(passes(0, 1.0f, 0));
    EXPECT_TRUE(passes(1, 0.9375f, 0));
    EXPECT_TRUE(passes(2, 0.9375f, 0));
    EXPECT_TRUE(passes(1, 0.9375f, 1));
    EXPECT_TRUE(passes(2, 0.9375f, 2, true)); // the same two pixels
    EXPECT_FALSE(passes(2, 0.9375f, 1));
    EXPECT_FALSE(passes(3, 0.9375f, 0));
    EXPECT_FALSE(passes(1, 0.5f, 0)); // a hole
    EXPECT_FALSE(passes(1, 0.0f, 0));
});

// A white half beside a black one, 64 × 64: 4 pixels may differ at the edge.
const Test forgives_what_an_edge_explains("unit.golden.edges.forgives_what_an_edge_explains", [] {
    Image reference = grey(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 32; x < 64; ++x) std::ranges::fill(reference.at(x, y), 0.1f);
    const auto passes = [&reference](std::initializer_list<std::pair<int, int>> places, float value) {
        Image test = reference;
        for (const auto& [x, y] : places) std::ranges::fill(test.at(x, y), value);
        CompareOptions options;
        options.tolerances = {parse_tolerance("rel=0.01@edges")};
        return compare(test, reference, options).passed;
    };
    EXPECT_TRUE(passes({{32, 10}}, 1.0f));  // fell to the other side
    EXPECT_TRUE(passes({{31, 10}}, 0.5f));  // half of it
    EXPECT_FALSE(passes({{31, 10}}, 0.0f)); // darker than both sides
    EXPECT_FALSE(passes({{30, 10}}, 0.1f)); // not at the edge
    EXPECT_TRUE(passes({{32, 10}, {32, 11}, {32, 12}}, 1.0f));
    EXPECT_FALSE(passes({{32, 10}, {32, 11}, {32, 12}, {32, 13}, {32, 14}}, 1.0f)); // the edge moved
    EXPECT_FALSE(passes({{32, 4}, {32, 14}, {32, 24}, {32, 34}, {32, 44}}, 1.0f));  // too many
});

// A highlight about three pixels wide, moved by a part of a pixel.
const Test a_slope("unit.golden.edges.a_highlight_moves_by_the_rounding_of_places", [] {
    const auto highlight = [](float dx) {
        Image image = grey(64, 64, 3, 0.3f);
        for (int y = 28; y < 37; ++y)
            for (int x = 28; x < 37; ++x) {
                const float u = static_cast<float>(x) - 31.6f - dx, v = static_cast<float>(y) - 32.1f;
                for (float& value : image.at(x, y)) value += 20.0f * std::exp(-1.5f * (u * u + v * v));
            }
        return image;
    };
    const auto passes = [&](const Image& test) { return compare(test, highlight(0.0f)).passed; };
    EXPECT_FALSE(passes(highlight(0.03f))); // as many pixels as an object
    EXPECT_FALSE(passes(highlight(0.2f)));
    Image test = highlight(0.0f);
    for (const int x : {31, 32}) std::ranges::fill(test.at(x, 32), 1.015f * test.at(x, 32)[0]);
    EXPECT_TRUE(passes(test));
    std::ranges::fill(test.at(31, 32), 1.05f * highlight(0.0f).at(31, 32)[0]);
    EXPECT_FALSE(passes(test));
    Image even = highlight(0.0f);
    std::ranges::fill(even.at(10, 10), 1.015f * 0.3f);
    EXPECT_FALSE(passes(even)); // no slope is there
});

// A slanted band on a slope: the column that repeats the one before it differs plainly in two pixels alone.
const Test a_column("unit.golden.edges.a_repeated_column_is_no_edge", [] {
    const auto is_bright = [](int x, int y) { return y > x && y <= x + 28; };
    Image reference = grey(64, 64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            std::ranges::fill(reference.at(x, y),
                              (is_bright(x, y) ? 1.0f : 0.3f) * (1.0f + 0.001f * static_cast<float>(x)));
    Image flipped = reference, repeated = reference;
    for (int y = 0; y < 64; ++y) {
        std::ranges::copy(reference.at(30, y), repeated.at(31, y).begin());
        if (is_bright(30, y) != is_bright(31, y))
            std::ranges::copy(reference.at(30, y), flipped.at(31, y).begin());
    }
    EXPECT_TRUE(compare(flipped, reference).passed);
    EXPECT_FALSE(compare(repeated, reference).passed);
});

const Test a_wire_is_no_edge("unit.golden.edges.a_wire_is_no_edge", [] {
    Image with = grey(64, 64), without = grey(64, 64);
    for (int x = 20; x < 23; ++x) std::ranges::fill(with.at(x, 30), 0.2f);
    EXPECT_FALSE(compare(without, with).passed);
    EXPECT_FALSE(compare(with, without).passed);
});

// A shift of a tenth of the noise is lost in each pixel and plain in the sum of 64 × 64 of them.
const Test sums_find_what_pixels_hide("unit.golden.noise.sums_find_what_pixels_hide", [] {
    const Image reference = grey(64, 64);
    const CompareOptions options{.noise = {grey(1, 1, 1, 0.1f)}};
    const Comparison comparison = compare(grey(64, 64, 3, 1.01f), reference, options);
    EXPECT_NEAR(comparison.metrics.max_z, 0.1, 1e-3);
    EXPECT_NEAR(comparison.metrics.max_block_z, 0.1 * 16.0, 1e-2);
    EXPECT_NEAR(comparison.metrics.total_z, 0.1 * 64.0, 1e-2);
    EXPECT_FALSE(comparison.passed);
    EXPECT_TRUE(compare(grey(64, 64, 3, 1.001f), reference, options).passed);
});

const Test poisson("unit.golden.noise.most_events", [] {
    EXPECT_EQ(most_events(0.0, 1e-3), 0u);
    EXPECT_EQ(most_events(2.0 / 14.0, 1e-3 / 3.0), 3u); // P(more than 2) is 4.4e-4, P(more than 3) 1.6e-5
    EXPECT_EQ(most_events(1.0, 0.02), 3u);              // 0.080, 0.019
    EXPECT_NEAR(t_of_z(z_of_t(7.0, 11.0), 11.0), 7.0, 1e-9);
});

// Variances of chi-squared laws with 11 degrees of freedom: of one true variance, and of true ones that
// scatter.
const Test moderated("unit.golden.noise.variances_of_blocks_tell_each_other", [] {
    std::mt19937 random(11);
    const auto measured = [&](double spread) {
        std::chi_squared_distribution<double> chi(11.0);
        std::normal_distribution<double> normal(0.0, spread);
        std::vector<double> variances(20000);
        std::ranges::generate(variances, [&] { return 3.0 * std::exp(normal(random)) * chi(random) / 11.0; });
        return prior_of(variances, 11.0);
    };
    const VariancePrior alike = measured(0.0), uneven = measured(2.0);
    EXPECT_NEAR(alike.value, 3.0, 0.05);
    EXPECT_GT(alike.degrees_of_freedom, 200.0); // trigamma(5.5) / 100, one standard error, has 1000
    EXPECT_LT(uneven.degrees_of_freedom, 2.0);
    EXPECT_NEAR(uneven.moderated(10.0, 11.0), 10.0, 1.5);
    EXPECT_NEAR(alike.moderated(10.0, 11.0), 3.0, 0.4);
    EXPECT_EQ(prior_of({1.0, 2.0, 0.0}, 11.0).degrees_of_freedom, 0.0); // too few
    EXPECT_EQ(prior_of({}, 11.0).moderated(2.0, 11.0), 2.0);
});

// A line of uneven pixels is an edge; a single one is an event.
const Test seen("unit.golden.noise.events_that_seeds_had", [] {
    Image errors = grey(64, 48, 1, 0.01f);
    for (int x = 0; x < 64; ++x) errors.at(x, 10)[0] = 1.0f;
    EXPECT_EQ(seen_events(errors, 12.0, 14.0), 0u);
    errors.at(20, 30)[0] = 1.0f;
    errors.at(40, 40)[0] = errors.at(41, 40)[0] = 1.0f; // of two pixels
    EXPECT_EQ(seen_events(errors, 12.0, 14.0), 3u);
    errors.at(50, 30)[0] = 0.02f;
    EXPECT_EQ(seen_events(errors, 12.0, 14.0), 3u);
});

// The frame has room for 8 of them (2 and a ten-thousandth of the pixels), but the seeds had none.
const Test no_more_than_seen("unit.golden.noise.rare_events_are_no_more_than_the_seeds_tell", [] {
    std::mt19937 random(10);
    std::normal_distribution<float> normal(1.0f, 0.02f);
    const auto seed = [&](int events) {
        Image image = grey(300, 200);
        std::ranges::generate(image.pixels, [&] { return normal(random); });
        for (int i = 0; i < events; ++i)
            std::ranges::fill(image.at(static_cast<int>(random() % 300), static_cast<int>(random() % 200)),
                              3.0f);
        return image;
    };
    const auto passes = [&](int events_of_seeds, int events) {
        NoiseOfSeeds noise;
        for (int i = 0; i < 12; ++i) noise.add(seed(events_of_seeds));
        const Image errors = noise.errors();
        return compare(seed(events), seed(0), {.noise = {errors, errors}}).passed;
    };
    EXPECT_TRUE(passes(0, 2));
    EXPECT_FALSE(passes(0, 7));
    EXPECT_TRUE(passes(3, 7));
    EXPECT_FALSE(passes(3, 9));
});

// Neither a few large terms nor the lack of them moves such a sum away from 0.
const Test winsorised("unit.golden.noise.winsorised_sums", [] {
    const auto sum_of = [](std::initializer_list<double> terms, std::size_t limited) {
        WinsorisedSums sums(2, limited);
        double plain = 0.0;
        for (const double term : terms) {
            sums.add(1, term);
            plain += term;
        }
        return sums.nearer_to_0(1, plain);
    };
    EXPECT_EQ(sum_of({1.0, 2.0, 9.0, 4.0}, 0), 16.0);
    EXPECT_EQ(sum_of({1.0, 2.0, 9.0, 4.0}, 1), 11.0);
    EXPECT_EQ(sum_of({1.0, 2.0, 9.0, 4.0}, 2), 7.0);
    EXPECT_EQ(sum_of({3.0, 3.0, 3.0, 3.0}, 2), 12.0); // a change of all is kept
    EXPECT_EQ(sum_of({-1.0, -2.0, -9.0}, 1), -5.0);
    EXPECT_EQ(sum_of({5.0, 5.0, 5.0, -20.0, -1.0}, 1), -6.0); // the plain sum is nearer
    EXPECT_EQ(sum_of({7.0}, 3), 0.0);
    EXPECT_EQ(sum_of({}, 3), 0.0);
});

const Test heat_map_colors("unit.golden.pictures.heat_map_colors", [] {
    Comparison comparison;
    comparison.error = Image(5, 1, 1);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::ranges::copy(std::array{0.0f, 1.0f, 1e9f, nan, -1.0f}, comparison.error.pixels.begin());
    const Image map = heat_map(comparison);
    const auto color = [&map](int x) { return sr::vec3(map.at(x, 0)[0], map.at(x, 0)[1], map.at(x, 0)[2]); };
    EXPECT_EQ(color(0), sr::image::viridis.front());
    EXPECT_EQ(color(1), sr::image::colormap(0.5f)); // at the limit
    EXPECT_EQ(color(2), sr::image::viridis.back());
    EXPECT_EQ(std::vector<float>(map.at(3, 0).begin(), map.at(3, 0).end()),
              (std::vector<float>{1.0f, 0.0f, 1.0f}));
    EXPECT_GT(map.at(4, 0)[2], map.at(4, 0)[0]);
});

const Test side_by_side_holds_three("unit.golden.pictures.side_by_side_holds_three", [] {
    const Image reference = grey(10, 6), test = grey(10, 6, 3, 2.0f);
    const Comparison comparison = compare(test, reference);
    const Image all = side_by_side(test, reference, comparison);
    EXPECT_EQ(all.width, 3 * 10 + 2 * 4);
    EXPECT_EQ(all.height, 6);
    EXPECT_GT(all.at(2, 2)[0], all.at(16, 2)[0]); // the test is brighter
    const Comparison other_size = compare(grey(3, 9), reference);
    EXPECT_EQ(side_by_side(grey(3, 9), reference, other_size).height, 9);
});

} // namespace
