// The lobe of a pixel: where its directions lie, and how its values are drawn.
#include "viewer/panels/lobe.hpp"

#include "support/address.hpp"

#include <cmath>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

const Test grid("unit.viewer.lobe.directions_reach_from_the_mirrored_one_to_the_horizon", [] {
    const vec3 n = glm::normalize(vec3(0.3f, 0.9f, -0.2f));
    const vec3 t = glm::normalize(glm::cross(n, vec3(1, 0, 0)));
    for (const float theta : {0.0f, 0.4f, 1.5f}) {
        const vec3 wo = std::cos(theta) * n + std::sin(theta) * t;
        Lobe lobe;
        lobe.n = n;
        lobe.wo = wo;
        lobe.wi = lobe_directions(n, wo);
        ASSERT_EQ(lobe.wi.size(), LobeGrid::size());
        EXPECT_NEAR(plane_angle(lobe, lobe.wi[0]), theta, 1e-3f);
        for (const vec3 wi : lobe.wi) {
            EXPECT_NEAR(glm::length(wi), 1.0f, 1e-5f);
            EXPECT_GT(glm::dot(wi, n), 0.0f);
        }
        for (std::size_t m = 0; m < LobeGrid::meridians; ++m)
            EXPECT_LT(glm::dot(lobe.wi[LobeGrid::index(m, LobeGrid::points)], n), 0.01f) << m;
        for (const std::size_t m : {std::size_t{0}, LobeGrid::meridians / 2})
            for (std::size_t i = 1; i <= LobeGrid::points; ++i) {
                const vec3 wi = lobe.wi[LobeGrid::index(m, i)];
                EXPECT_NEAR(glm::dot(wi, glm::cross(n, t)), 0.0f, theta > 0.0f ? 1e-3f : 1.0f);
            }
    }
});

const Test radius("unit.viewer.lobe.radii_are_shares_of_the_largest_value", [] {
    Lobe lobe;
    lobe.n = lobe.wo = vec3(0, 0, 1);
    lobe.wi = lobe_directions(lobe.n, lobe.wo);
    lobe.f_r.assign(lobe.wi.size(), 0.25f); // a Lambert surface: f_r is a half sphere, f_r cosθ a whole one
    const LobeSettings plain{false, false}, cosine{true, false}, logarithmic{false, true};
    EXPECT_FLOAT_EQ(scale_of(lobe, plain).largest, 0.25f);
    EXPECT_FLOAT_EQ(scale_of(lobe, cosine).largest, 0.25f);
    const vec3 slanted = glm::normalize(vec3(1, 0, 1));
    EXPECT_FLOAT_EQ(shown_value(lobe, slanted, 0.25f, plain), 0.25f);
    EXPECT_FLOAT_EQ(shown_value(lobe, slanted, 0.25f, cosine), 0.25f * std::sqrt(0.5f));
    EXPECT_EQ(shown_value(lobe, vec3(0, 0, -1), 0.25f, plain), 0.0f);
    EXPECT_EQ(scale_of(lobe, logarithmic).decades, 2.0f);
    lobe.f_r[0] = 2500.0f; // a peak of four decades
    EXPECT_EQ(scale_of(lobe, logarithmic).decades, 5.0f);
    EXPECT_EQ(shown_radius(0.0f, {0.25f, 3.0f}), 0.0f);
    EXPECT_NEAR(shown_radius(0.025f, {0.25f, 3.0f}), 2.0f / 3.0f, 1e-6f);
    EXPECT_NEAR(shown_radius(0.025f, {0.25f, 0.0f}), 0.1f, 1e-7f);
});

} // namespace
