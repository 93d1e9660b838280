#include "scene/lights/environment.hpp"

#include "scene/lights/light.hpp"
#include "support/address.hpp"

#include <cmath>
#include <random>

using namespace sr;
using namespace sr::scene;
using sr::testing::Test;

namespace {

/// Texels of uneven light, one of them as hot as the sun.
EnvironmentMap uneven() {
    std::vector<vec3> texels;
    for (int i = 0; i < 16 * 7; ++i)
        texels.emplace_back(0.1f * static_cast<float>(i % 11), 0.5f, 0.01f * static_cast<float>(i));
    texels[40] = vec3(1e9f);
    return {16, 7, texels};
}

const Test orientation("unit.scene.environment.the_middle_column_is_minus_z", [] {
    const auto expect_at = [](vec3 w, vec2 place) {
        EXPECT_NEAR(EnvironmentMap::place_of(w).x, place.x, 1e-6f);
        EXPECT_NEAR(EnvironmentMap::place_of(w).y, place.y, 1e-6f);
        EXPECT_LT(glm::distance(EnvironmentMap::direction_of(place), w), 1e-6f);
    };
    expect_at({0, 0, -1}, {0.5f, 0.5f});
    expect_at({1, 0, 0}, {0.75f, 0.5f});
    expect_at({-1, 0, 0}, {0.25f, 0.5f});
    EXPECT_NEAR(EnvironmentMap::place_of({0, 1, 0}).y, 0.0f, 1e-6f);
    EXPECT_NEAR(EnvironmentMap::place_of({0, -1, 0}).y, 1.0f, 1e-6f);
});

const Test rotation("unit.scene.environment.rotation_is_counter_clockwise_seen_from_above", [] {
    EnvironmentLight light;
    light.rotation = 0.5f * pi;
    EXPECT_LT(glm::distance(light.map_from_world() * vec3(-1, 0, 0), vec3(0, 0, -1)), 1e-6f);
});

const Test bilinear("unit.scene.environment.radiance_is_bilinear_and_goes_around", [] {
    const EnvironmentMap map(4, 2, {vec3(0), vec3(1), vec3(2), vec3(3), vec3(4), vec3(5), vec3(6), vec3(7)});
    const auto at = [&](float x, float y) {
        return map.radiance(EnvironmentMap::direction_of({x / 4, y / 2})).x;
    };
    EXPECT_NEAR(at(1.5f, 0.5f), 1.0f, 1e-5f);
    EXPECT_NEAR(at(2.0f, 1.0f), 3.5f, 1e-5f);
    EXPECT_NEAR(at(4.0f, 0.5f), 1.5f, 1e-4f) << "between the last column and the first";
    EXPECT_NEAR(at(1.5f, 0.01f), 1.0f, 1e-4f) << "constant towards the pole";
});

/// The integral of f over all directions, by a grid that is 32 times as fine as the map's texels.
template<class Function>
double over_directions(const EnvironmentMap& map, const Function& f) {
    const int columns = 32 * map.width(), rows = 32 * map.height();
    double sum = 0.0;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const vec2 place((static_cast<float>(i) + 0.5f) / static_cast<float>(columns),
                             (static_cast<float>(j) + 0.5f) / static_cast<float>(rows));
            sum += f(EnvironmentMap::direction_of(place)) * std::sin(pi * place.y);
        }
    return sum * 2.0 * pi * pi / (static_cast<double>(columns) * rows);
}

// E[L / p] over samples is the integral of L: the density is that of the sampling.
const Test density("unit.scene.environment.samples_have_their_density", [] {
    const EnvironmentMap map = uneven();
    EXPECT_NEAR(over_directions(map, [&](vec3 w) { return map.density(w); }), 1.0, 1e-3);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    double light = 0.0;
    constexpr int count = 1 << 17;
    for (int i = 0; i < count; ++i) {
        const vec3 w = map.sample({uniform(random), uniform(random)});
        ASSERT_NEAR(glm::length(w), 1.0f, 1e-5f);
        ASSERT_GT(map.density(w), 0.0);
        light += map.radiance(w).g / map.density(w) / count;
    }
    const double integral = over_directions(map, [&](vec3 w) { return map.radiance(w).g; });
    EXPECT_NEAR(light / integral, 1.0, 5e-3);
    EXPECT_NEAR(integral / (4.0 * pi * map.mean().g), 1.0, 0.05);
});

const Test dark("unit.scene.environment.without_light", [] {
    const EnvironmentMap map(4, 2, std::vector<vec3>(8, vec3(0.0f)));
    EXPECT_FALSE(map.has_light());
    EXPECT_EQ(map.density({0, 1, 0}), 0.0);
});

} // namespace
