#include "support/address.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int size = 65; // odd: a pixel's centre lies at the nadir
constexpr float extent = 2.0f;

image::Image lit_by(const scene::Light& light, vec3 rho = vec3(1.0f)) {
    const std::vector<scene::Light> lights{light};
    return picture(lambert_plane(2.0f * extent, rho), lights, camera_from_above(extent), size);
}

/// Compares every pixel of a picture with a closed form of the place on the plane.
template<class Form>
void expect_everywhere(const image::Image& image, Form form, float tolerance) {
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const float expected = form(place_of(x, y, size, extent));
            ASSERT_NEAR(image.at(x, y)[0], expected, tolerance * std::max(expected, 1e-3f))
                << "pixel " << x << ',' << y;
        }
    }
}

const Test nadir("law.light.point.one_metre_above_a_lambert_plane", [] {
    const auto image = lit_by(scene::PointLight{"", {0.0f, 1.0f, 0.0f}, vec3(1.0f)});
    EXPECT_NEAR(image.at(size / 2, size / 2)[0], 1.0f / pi, 1e-4f / pi);
});

// E = I cosθ / d² = I h / d³.
const Test inverse_square("law.light.point.inverse_square", [] {
    for (const float h : {0.25f, 1.0f, 4.0f}) {
        const auto image = lit_by(scene::PointLight{"", {0.0f, h, 0.0f}, vec3(7.0f)});
        expect_everywhere(
            image, [h](vec2 p) { return 7.0f * h / std::pow(dot(p, p) + h * h, 1.5f) / pi; }, 1e-4f);
    }
});

// KHR_lights_punctual: window max(min(1 - (d / range)⁴, 1), 0) on top of 1 / d².
const Test range("law.light.point.range_window", [] {
    scene::PointLight light{"", {0.0f, 1.0f, 0.0f}, vec3(1.0f)};
    light.range = 1.5f;
    const auto form = [](vec2 p) {
        const float d2 = dot(p, p) + 1.0f;
        return std::max(0.0f, 1.0f - d2 * d2 / std::pow(1.5f, 4.0f)) / std::pow(d2, 1.5f) / pi;
    };
    expect_everywhere(lit_by(light), form, 2e-4f);
});

// L = E ρ cosθ / π, the same everywhere.
const Test directional("law.light.directional.lambert", [] {
    for (const float angle : {0.0f, 0.5f, 1.2f}) {
        const vec3 direction(std::sin(angle), -std::cos(angle), 0.0f);
        const auto image = lit_by(scene::DirectionalLight{"", direction, vec3(10.0f, 20.0f, 30.0f)},
                                  vec3(0.5f, 0.25f, 1.0f));
        for (const auto& [channel, E_rho] : {std::pair{0, 5.0f}, {1, 5.0f}, {2, 30.0f}})
            EXPECT_NEAR(image.at(10, 50)[channel], E_rho * std::cos(angle) / pi, 1e-4f * E_rho);
    }
});

// KHR_lights_punctual: saturate((cosθ - cos outer) / (cos inner - cos outer))², on top of the point light.
const Test spot("law.light.spot.squared_falloff", [] {
    scene::SpotLight light{"", {0.0f, 1.5f, 0.0f}, {0.0f, -1.0f, 0.0f}, vec3(3.0f)};
    light.inner_angle = 0.3f;
    light.outer_angle = 0.8f;
    const auto form = [](vec2 p) {
        const float d = std::sqrt(dot(p, p) + 1.5f * 1.5f), cosine = 1.5f / d;
        const float t = std::clamp((cosine - std::cos(0.8f)) / (std::cos(0.3f) - std::cos(0.8f)), 0.0f, 1.0f);
        return 3.0f * t * t * cosine / (d * d) / pi;
    };
    expect_everywhere(lit_by(light), form, 5e-4f);
    EXPECT_EQ(lit_by(light).at(0, 0)[0], 0.0f) << "beyond the cone there is no light";
});

// A surface that faces away receives nothing, whatever the light.
const Test horizon("law.light.nothing_from_below_the_horizon", [] {
    const vec3 below(0.3f, -1.0f, 0.2f);
    const auto is_black = [](const image::Image& image) {
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                if (image.at(x, y)[0] != 0.0f) return false;
        return true;
    };
    EXPECT_TRUE(is_black(lit_by(scene::PointLight{"", below, vec3(1.0f)})));
    EXPECT_TRUE(is_black(lit_by(scene::DirectionalLight{"", {0.0f, 1.0f, 0.0f}, vec3(1.0f)})));
    EXPECT_TRUE(is_black(lit_by(scene::RectangleLight{"", below, {0.1f, 0, 0}, {0, 0, -0.1f}, vec3(1.0f)})));
});

// A rectangle emits on the side of cross(half_u, half_v); a two-sided one on both.
const Test sides("law.light.rectangle.has_a_front", [] {
    scene::RectangleLight light{"", {0.0f, 1.0f, 0.0f}, {0.1f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.1f}, vec3(1.0f)};
    const int middle = size / 2;
    ASSERT_LT(light.normal().y, 0.0f);
    const float front = lit_by(light).at(middle, middle)[0];
    EXPECT_GT(front, 0.0f);
    std::swap(light.half_u, light.half_v);
    EXPECT_EQ(lit_by(light).at(middle, middle)[0], 0.0f);
    light.is_two_sided = true;
    EXPECT_GT(lit_by(light).at(middle, middle)[0], 0.5f * front);
});

// A small rectangle of radiance L is a point light of intensity L A cosθ_y on its axis.
const Test point_limit("law.light.rectangle.small_is_a_point", [] {
    constexpr float edge = 0.01f;
    const scene::RectangleLight light{
        "", {0.0f, 1.0f, 0.0f}, {0.5f * edge, 0.0f, 0.0f}, {0.0f, 0.0f, 0.5f * edge}, vec3(500.0f)};
    const auto form = [](vec2 p) {
        const float d2 = dot(p, p) + 1.0f; // cosθ = cosθ_y = 1 / d
        return 500.0f * edge * edge / (d2 * d2) / pi;
    };
    const auto image = lit_by(light);
    for (int x = 0; x < size; x += 8)
        EXPECT_NEAR(image.at(x, size / 2)[0] / form(place_of(x, size / 2, size, extent)), 1.0f, 0.02f);
});

} // namespace
