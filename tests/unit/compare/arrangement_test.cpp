// Places of failing pixels that chance does not choose.
#include "compare/arrangement.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <random>
#include <set>

using namespace sr::compare;
using sr::testing::Test;

namespace {

using Places = std::vector<std::size_t>;

/// Sorted places that chance chooses among those of a line.
Places chosen_by_chance(std::size_t count, std::size_t length, std::mt19937& random) {
    std::set<std::size_t> places;
    std::uniform_int_distribution<std::size_t> place(0, length - 1);
    while (places.size() < count) places.insert(place(random));
    return {places.begin(), places.end()};
}

/// Places that lie `step` apart, each moved by at most `jitter` either way.
Places serrated(std::size_t count, std::size_t step, std::size_t jitter, std::mt19937& random) {
    Places places;
    std::uniform_int_distribution<std::size_t> moved(0, 2 * jitter);
    for (std::size_t k = 0; k < count; ++k) places.push_back(10 + k * step + moved(random));
    return places;
}

bool is_column_in_line(const Places& places) {
    constexpr std::size_t width = 3840;
    std::unordered_set<std::size_t> pixels;
    for (const std::size_t place : places) pixels.insert(place * width + 1295);
    return are_in_line(pixels, width);
}

double share_of(const std::vector<double>& chances, double limit) {
    return static_cast<double>(std::ranges::count_if(chances, [&](double p) { return p < limit; }))
           / static_cast<double>(chances.size());
}

// A chance is one if it is uniform where its hypothesis holds. The limits are four standard deviations of a
// share of 4000 draws.
const Test is_a_chance("unit.golden.compare.arrangement.evenness_is_a_chance", [] {
    std::mt19937 random(1);
    for (const std::size_t count : {4, 8, 16, 40}) {
        std::vector<double> chances;
        for (int k = 0; k < 4000; ++k)
            chances.push_back(chance_of_evenness(chosen_by_chance(count, 100000, random)));
        EXPECT_NEAR(share_of(chances, 0.05), 0.05, 0.0138) << count;
        EXPECT_NEAR(share_of(chances, 0.5), 0.5, 0.0316) << count;
    }
});

const Test few("unit.golden.compare.arrangement.few_places_are_not_even", [] {
    for (const Places& places : {Places{}, {7}, {7, 9}, {7, 8, 9}, {3, 4, 100, 101}})
        EXPECT_EQ(chance_of_evenness(places), 1.0) << places.size();
    EXPECT_EQ(chance_of_evenness({10, 13, 16, 19}), 1.0) << "close";
    EXPECT_EQ(chance_of_evenness({10, 30, 50, 70}), 0.0);
    EXPECT_EQ(chance_of_evenness({10, 30, 31, 50, 70, 71}), 0.0) << "places that touch are one";
});

const Test straight_edge("unit.golden.compare.arrangement.pixels_of_a_straight_edge", [] {
    std::mt19937 random(2);
    int wrong = 0;
    for (int k = 0; k < 500; ++k) wrong += is_column_in_line(chosen_by_chance(15, 1200, random));
    EXPECT_LE(wrong, 5) << "of 500 edges of which chance chose 15 pixels of 1200";
    wrong = 0;
    for (int k = 0; k < 500; ++k) wrong += is_column_in_line(chosen_by_chance(9, 100, random));
    EXPECT_LE(wrong, 5) << "of 500 edges of which chance chose 9 pixels of 100";
});

const Test serration("unit.golden.compare.arrangement.a_serrated_edge", [] {
    std::mt19937 random(3);
    EXPECT_TRUE(is_column_in_line(serrated(4, 9, 0, random)));
    int found = 0;
    for (int k = 0; k < 100; ++k) found += is_column_in_line(serrated(20, 8, 2, random));
    EXPECT_GE(found, 95) << "of 100 edges with a tooth in 8 pixels, moved by up to 2";
    found = 0;
    for (int k = 0; k < 100; ++k) found += is_column_in_line(serrated(10, 40, 6, random));
    EXPECT_GE(found, 95) << "of 100 edges with a tooth in 40 pixels, moved by up to 6";
    found = 0;
    for (int k = 0; k < 100; ++k) found += is_column_in_line(serrated(20, 60, 20, random));
    EXPECT_GE(found, 95) << "of 100 edges with a tooth in 60 pixels, moved by up to 20";
});

const Test rectangle("unit.golden.compare.arrangement.corners", [] {
    EXPECT_TRUE(are_in_rectangle({205, 209, 605, 609}, 100));
    EXPECT_FALSE(are_in_rectangle({205, 209, 605, 608}, 100));
    EXPECT_FALSE(are_in_rectangle({205, 206, 305, 306}, 100)) << "a cluster";
});

} // namespace
