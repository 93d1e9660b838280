#include "law/direction_counts.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace sr::testing {
namespace {

vec3 across(vec3 axis) {
    return glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0)));
}

/// 1 - cos of the cone's half angle.
double height_of(const View& view) {
    return 2.0 * std::pow(std::sin(0.5 * static_cast<double>(view.cone)), 2.0);
}

constexpr int rings = 12, sectors = 12, fine = 48;

int cell_of(const View& view, vec3 w) {
    const vec3 u = across(view.axis), v = glm::cross(view.axis, u);
    const vec3 chord = w - view.axis;
    const float h = 0.5f * glm::dot(chord, chord) / static_cast<float>(height_of(view));
    const float phi = std::atan2(glm::dot(w, v), glm::dot(w, u)) / (2.0f * pi);
    const int ring = static_cast<int>(h * rings),
              sector = static_cast<int>((phi < 0.0f ? phi + 1.0f : phi) * sectors);
    return ring < rings ? ring * sectors + std::min(sector, sectors - 1) : -1;
}

/// The density integrated over each cell of the grid.
std::vector<double> integrals(const View& view, const std::vector<vec4>& densities) {
    std::vector<double> cells(rings * sectors, 0.0);
    const double d_omega = 2.0 * pi * height_of(view) / (rings * fine * sectors * fine);
    for (int i = 0; i < static_cast<int>(densities.size()); ++i) {
        const int ring = i / (sectors * fine) / fine, sector = i % (sectors * fine) / fine;
        cells[static_cast<std::size_t>(ring * sectors + sector)] +=
            densities[static_cast<std::size_t>(i)].x * d_omega;
    }
    return cells;
}

std::vector<vec4> sampled_directions(const View& view, const render::GpuScene& scene, int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f - 1e-7f);
    std::vector<Row> rows;
    for (int i = 0; i < count; ++i)
        rows.push_back({vec4(view.x, 0.0f), vec4(uniform(random), uniform(random), 0, 0)});
    return evaluate("#include \"light/sample_light.glsl\"",
                    "LightSample s = sample_light(0, a.xyz, b.xy); return vec4(s.wi, s.p);", rows, &scene);
}

/// Pearson's statistic over the cells that expect 10 samples or more, the others taken together; in units of
/// its own standard deviation above its mean, so that 5 has a probability below 1e-5.
double chi_squared_excess(const std::vector<double>& expected, const std::vector<int>& counts, int total) {
    double statistic = 0.0, rest_expected = 0.0;
    int rest = 0, cells = -1;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const double e = expected[i] * total;
        if (e < 10.0) {
            rest_expected += e;
            rest += counts[i];
            continue;
        }
        statistic += (counts[i] - e) * (counts[i] - e) / e;
        ++cells;
    }
    if (rest_expected >= 10.0) {
        statistic += (rest - rest_expected) * (rest - rest_expected) / rest_expected;
        ++cells;
    } else {
        EXPECT_LE(rest, 40) << "samples where the density is next to nothing";
    }
    return cells > 0 ? (statistic - cells) / std::sqrt(2.0 * cells) : 0.0;
}

} // namespace

// (Jittered, since the edges of lights like to run along the lines of a regular one.)
std::vector<Row> grid(const View& view) {
    const vec3 u = across(view.axis), v = glm::cross(view.axis, u);
    const auto height = static_cast<float>(height_of(view));
    std::mt19937 random(1);
    std::uniform_real_distribution<float> jitter(0.0f, 1.0f);
    std::vector<Row> rows;
    for (int ring = 0; ring < rings * fine; ++ring) {
        for (int sector = 0; sector < sectors * fine; ++sector) {
            const float h = height * (static_cast<float>(ring) + jitter(random)) / (rings * fine);
            const float s = std::sqrt(h * (2.0f - h));
            const float phi = 2.0f * pi * (static_cast<float>(sector) + jitter(random)) / (sectors * fine);
            const vec3 w = (1.0f - h) * view.axis + s * (std::cos(phi) * u + std::sin(phi) * v);
            rows.push_back({vec4(view.x, 0.0f), vec4(w, 0.0f)});
        }
    }
    return rows;
}

std::vector<vec4> expect_counts(const View& view, const render::GpuScene& scene,
                                const std::vector<vec4>& densities) {
    const std::vector<double> expected = integrals(view, densities);
    double total = 0.0;
    for (const double cell : expected) total += cell;
    EXPECT_NEAR(total, 1.0, 0.01) << "the density's integral";

    constexpr int count = 1 << 16;
    auto samples = sampled_directions(view, scene, count);
    std::vector<int> counts(rings * sectors, 0);
    int beside = 0;
    for (const vec4 s : samples) {
        const int cell = cell_of(view, vec3(s));
        if (cell < 0)
            ++beside;
        else
            ++counts[static_cast<std::size_t>(cell)];
    }
    EXPECT_EQ(beside, 0) << "directions beside the light";
    EXPECT_LT(chi_squared_excess(expected, counts, count), 5.0);
    return samples;
}

} // namespace sr::testing
