// Interpolation against the closed forms of glTF 2.0, appendix C.
#include "gltf/read/animation.hpp"
#include "loading.hpp"

#include <cmath>

using namespace sr;
using namespace sr::gltf;
using sr::testing::Test;

namespace {

Track track(std::vector<float> times, std::vector<float> values, Interpolation interpolation) {
    Track result;
    result.times = std::move(times);
    result.values = std::move(values);
    result.interpolation = interpolation;
    return result;
}

const Test ends("unit.gltf.track.ends_are_held", [] {
    for (const auto interpolation : {Interpolation::step, Interpolation::linear})
        for (const auto& [when, value] : {std::pair{-1.0, 5.0}, {1.0, 5.0}, {3.0, 7.0}, {99.0, 7.0}})
            EXPECT_EQ(track({1, 3}, {5, 7}, interpolation).at(when), std::vector{value});
    EXPECT_EQ(track({2}, {5}, Interpolation::linear).at(1.0), std::vector{5.0});
});

const Test step("unit.gltf.track.step_holds_until_the_next_key", [] {
    const Track made = track({0, 1, 2}, {1, 2, 4}, Interpolation::step);
    EXPECT_EQ(made.at(0.999), std::vector{1.0});
    EXPECT_EQ(made.at(1.0), std::vector{2.0});
});

const Test linear("unit.gltf.track.linear_and_keys_at_one_time", [] {
    EXPECT_EQ(track({0, 2}, {1, 5}, Interpolation::linear).at(0.5), std::vector{2.0});
    const Track jump = track({0, 1, 1, 2}, {0, 1, 10, 20}, Interpolation::linear);
    EXPECT_EQ(jump.at(1.0), std::vector{10.0});
    EXPECT_EQ(jump.at(1.5), std::vector{15.0});
});

// The spline of x³ - 2x over keys at 1 and 3 is that cubic: four numbers determine one.
const Test cubic("unit.gltf.track.a_spline_is_the_cubic_through_its_keys", [] {
    const auto value = [](float x) { return x * x * x - 2.0f * x; };
    const auto slope = [](float x) { return 3.0f * x * x - 2.0f; };
    const Track made =
        track({1, 3}, {99, value(1), slope(1), slope(3), value(3), 99}, Interpolation::cubic_spline);
    EXPECT_EQ(made.at(1.0), std::vector{-1.0});
    EXPECT_EQ(made.at(3.0), std::vector{21.0});
    for (const double x : {1.25, 2.0, 2.9}) EXPECT_NEAR(made.at(x)[0], x * x * x - 2.0 * x, 1e-12);
});

std::vector<float> turn(float angle, float sign = 1.0f) {
    return {0, 0, sign * std::sin(angle / 2), sign * std::cos(angle / 2)};
}

// The angle about z runs evenly, the short way, also where the second quaternion is the negative one.
const Test rotation("unit.gltf.track.rotations_take_the_short_arc_evenly", [] {
    for (const float sign : {1.0f, -1.0f}) {
        std::vector<float> values = turn(0.3f);
        for (const float number : turn(2.3f, sign)) values.push_back(number);
        Track made = track({0, 4}, values, Interpolation::linear);
        made.width = 4;
        made.is_rotation = true;
        for (const double t : {1.0, 2.0, 3.5}) {
            const std::vector<double> q = made.at(t);
            EXPECT_NEAR(2.0 * std::atan2(q[2], q[3]), 0.3 + 0.5 * t, 1e-6) << sign;
            EXPECT_NEAR(q[2] * q[2] + q[3] * q[3], 1.0, 1e-6);
        }
    }
});

const Test unit_spline("unit.gltf.track.splines_of_rotations_are_unit", [] {
    std::vector<float> values(4, 0.0f);
    for (const auto& part : {turn(0.0f), {0, 0, 0, 0}, {0, 0, 0, 0}, turn(2.0f), {0, 0, 0, 0}})
        values.insert(values.end(), part.begin(), part.end());
    Track made = track({0, 1}, values, Interpolation::cubic_spline);
    made.width = 4;
    made.is_rotation = true;
    const std::vector<double> q = made.at(0.5);
    EXPECT_NEAR(q[2] * q[2] + q[3] * q[3], 1.0, 1e-12);
    EXPECT_NEAR(2.0 * std::atan2(q[2], q[3]), 1.0, 1e-6); // halfway, by symmetry
});

} // namespace
