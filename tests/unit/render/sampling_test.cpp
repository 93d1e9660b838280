#include "render/sampling.hpp"

#include "render/gpu/light_table.hpp"
#include "support/address.hpp"
#include "support/glsl_table.hpp"

#include <array>
#include <cmath>
#include <map>
#include <set>

using namespace sr;
using namespace sr::testing;

namespace {

// A (0,2)-sequence: of 2^k points, each elementary interval 2^-a × 2^-(k-a) holds exactly one.
const Test net("unit.render.sampling.is_a_net_in_base_two", [] {
    constexpr int k = 8;
    for (const std::uint32_t seed : {0u, 1u, 12345u}) {
        for (const std::uint32_t block : {0u, 3u}) {
            for (int a = 0; a <= k; ++a) {
                std::set<std::pair<int, int>> cells;
                for (std::uint32_t i = 0; i < 1u << k; ++i) {
                    const vec2 p = render::sobol_2d((block << k) + i, seed);
                    cells.emplace(static_cast<int>(std::ldexp(p.x, a)),
                                  static_cast<int>(std::ldexp(p.y, k - a)));
                }
                EXPECT_EQ(cells.size(), 1u << k)
                    << "seed " << seed << " block " << block << " columns 2^" << a;
            }
        }
    }
});

/// The coordinates of a sample in [0, 1): its place in the pixel and the four numbers behind it.
std::array<double, 6> six_numbers(int index, std::uint32_t seed) {
    const vec2 place = render::sub_pixel(index, 2, seed);
    std::array<double, 6> numbers{place.x, place.y};
    const std::array<std::uint32_t, 4> digits = render::sample_digits(index, seed);
    for (std::size_t d = 0; d < 4; ++d)
        for (int k = 0; k < 32; ++k) numbers[d + 2] += std::ldexp(digits[d] >> k & 1u, -1 - k);
    return numbers;
}

/// Calls `use` with all exponents of the first dimensions that have this sum.
void for_each_split(std::size_t dimensions, int sum, const auto& use, std::array<int, 6> exponents = {}) {
    if (dimensions == 1) {
        exponents[0] = sum;
        return use(exponents);
    }
    for (int a = 0; a <= sum; ++a) {
        exponents[dimensions - 1] = a;
        for_each_split(dimensions - 1, sum - a, use, exponents);
    }
}

// A (t,m,s)-net: each elementary interval of volume 2^(t-m) holds 2^t of 2^m points (Niederreiter 1987). What
// build/find_point_orders says of t.
const Test nets("unit.render.sampling.samples_fill_six_dimensions", [] {
    constexpr int m = 10;
    for (const auto& [dimensions, t] : {std::pair(2, 0), std::pair(4, 3), std::pair(6, 4)})
        for (const int first : {0, 5 << m})
            for (const std::uint32_t seed : {0u, 12345u}) {
                std::vector<std::array<double, 6>> points;
                for (int i = 0; i < 1 << m; ++i) points.push_back(six_numbers(first + i, seed));
                for_each_split(static_cast<std::size_t>(dimensions), m - t,
                               [&](const std::array<int, 6>& exponents) {
                                   std::map<std::array<int, 6>, int> counts;
                                   for (const std::array<double, 6>& point : points) {
                                       std::array<int, 6> cell{};
                                       for (std::size_t d = 0; d < 6; ++d)
                                           cell[d] = static_cast<int>(std::ldexp(point[d], exponents[d]));
                                       ++counts[cell];
                                   }
                                   for (const auto& [cell, count] : counts)
                                       ASSERT_EQ(count, 1 << t) << dimensions << " dimensions";
                               });
            }
});

const Test seeds("unit.render.sampling.seeds_give_other_points", [] {
    int same = 0;
    for (std::uint32_t i = 0; i < 256; ++i) same += render::sobol_2d(i, 1) == render::sobol_2d(i, 2);
    EXPECT_EQ(same, 0);
});

const Test alias_ties("unit.render.sampling.rounding_leaves_an_alias_table_as_it_is", [] {
    std::vector<double> weights(80, 1.0);
    for (std::size_t i = 0; i < weights.size(); i += 2) weights[i] = i % 4 == 0 ? 0.5 : 1.5;
    const std::vector<render::AliasEntry> exact = render::alias_table(weights);
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] *= 1.0 + 1e-7 * std::sin(7.0 * static_cast<double>(i));
    const std::vector<render::AliasEntry> rounded = render::alias_table(weights);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        EXPECT_EQ(rounded[i].alias, exact[i].alias) << i;
        EXPECT_NEAR(rounded[i].keep, exact[i].keep, 1e-5f) << i;
    }
});

const Test alias_weights("unit.render.sampling.an_alias_table_has_the_weights", [] {
    const std::vector<double> weights{0.0, 3.0, 1.0, 1.0, 7.0, 0.5, 2.0};
    const std::vector<render::AliasEntry> table = render::alias_table(weights);
    std::vector<double> chosen(weights.size(), 0.0); // times their number
    for (std::size_t i = 0; i < table.size(); ++i) {
        chosen[i] += table[i].keep;
        chosen[static_cast<std::size_t>(table[i].alias)] += 1.0 - table[i].keep;
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        EXPECT_NEAR(chosen[i] / 7.0, weights[i] / 14.5, 1e-6) << i;
        EXPECT_NEAR(table[i].probability, weights[i] / 14.5, 1e-6) << i;
    }
});

const Test center("unit.render.sampling.one_sample_looks_at_the_centre", [] {
    EXPECT_EQ(render::sub_pixel(0, 1, 99), vec2(0.5f));
    EXPECT_NE(render::sub_pixel(0, 2, 99), vec2(0.5f));
});

// The shaders draw the very same points.
const Test twin("unit.render.sampling.glsl_is_its_twin", [] {
    std::vector<Row> rows;
    for (int i = 0; i < 2048; ++i)
        rows.push_back({vec4(static_cast<float>(i * 7), static_cast<float>(i * 131), 0, 0)});
    const auto points = evaluate("#include \"base/sampling.glsl\"",
                                 "return vec4(sobol_2d(uint(a.x), uint(a.y)), 0.0, 0.0);", rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const vec2 expected = render::sobol_2d(static_cast<std::uint32_t>(rows[i][0].x),
                                               static_cast<std::uint32_t>(rows[i][0].y));
        EXPECT_EQ(vec2(points[i]), expected) << "row " << i;
    }
});

} // namespace
