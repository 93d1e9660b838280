#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/glsl_table.hpp"

#include <cmath>
#include <fmt/format.h>
#include <random>

using namespace sr;
using namespace sr::testing;

namespace {

/// One light as the point x sees it, and the cone of directions that it is looked for in.
struct View {
    scene::Light light;
    vec3 x{0.0f};
    vec3 axis{0.0f, 1.0f, 0.0f};
    float cone = 0.0f; // half angle [rad], holds the whole light
};

vec3 across(vec3 axis) {
    return glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 1, 0)));
}

/// 1 - cos of the cone's half angle.
double height_of(const View& view) {
    return 2.0 * std::pow(std::sin(0.5 * static_cast<double>(view.cone)), 2.0);
}

constexpr int rings = 12, sectors = 12, fine = 48;

/// Directions on a jittered grid in (1 - cosθ, φ), where areas are solid angles; fine² in each cell. (The
/// edges of lights like to run along the lines of a regular one.)
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

void expect_lawful(const View& view) {
    SCOPED_TRACE(fmt::format("from ({}, {}, {})", view.x.x, view.x.y, view.x.z));
    context();
    const scene::Scene nothing;
    const render::GpuScene scene(nothing, std::vector{view.light});
    const auto densities =
        evaluate("#include \"light/sample_light.glsl\"",
                 "return vec4(light_along(0, a.xyz, b.xyz).p, 0.0, 0.0, 0.0);", grid(view), &scene);
    const std::vector<double> expected = integrals(view, densities);
    double total = 0.0;
    for (const double cell : expected) total += cell;
    EXPECT_NEAR(total, 1.0, 0.01) << "the density's integral";

    constexpr int count = 1 << 16;
    const auto samples = sampled_directions(view, scene, count);
    std::vector<int> counts(rings * sectors, 0);
    std::vector<Row> again;
    for (const vec4 s : samples) {
        const int cell = cell_of(view, vec3(s));
        ASSERT_GE(cell, 0) << "a direction beside the light";
        ++counts[static_cast<std::size_t>(cell)];
        if (again.size() < 4096) again.push_back({vec4(view.x, 0.0f), vec4(vec3(s), 0.0f)});
    }
    EXPECT_LT(chi_squared_excess(expected, counts, count), 5.0);

    const auto backwards =
        evaluate("#include \"light/sample_light.glsl\"",
                 "return vec4(light_along(0, a.xyz, b.xyz).p, 0.0, 0.0, 0.0);", again, &scene);
    int missed = 0;
    for (std::size_t i = 0; i < again.size(); ++i) {
        if (backwards[i].x == 0.0f) {
            ++missed; // on the very edge
            continue;
        }
        ASSERT_NEAR(backwards[i].x / samples[i].w, 1.0, 2e-3)
            << "sampling and meeting the light give one density";
    }
    EXPECT_LT(missed, 8);
}

const scene::RectangleLight panel{"", {0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.3f}, vec3(1.0f)};
const scene::DiskLight ellipse{"", {0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.3f}, vec3(1.0f)};
const scene::TubeLight tube{"", {0, 1, 0}, {0.8f, 0.1f, 0}, 0.07f, vec3(1.0f)};
const scene::PolygonLight pentagon{
    "", {{0.5f, 1, 0}, {0.2f, 1, 0.5f}, {-0.4f, 1, 0.3f}, {-0.4f, 1, -0.3f}, {0.2f, 1, -0.5f}}, vec3(1.0f)};

const Test rectangle("law.emitter.rectangle.sampling_matches_density", [] {
    expect_lawful({panel, {0, 0, 0}, {0, 1, 0}, 0.6f});
    expect_lawful({panel, {0.4f, 0.9f, 0.1f}, {0, 1, 0}, 1.571f});                              // close by
    expect_lawful({panel, {2.5f, 0.7f, 0.3f}, glm::normalize(vec3(-2.5f, 0.3f, -0.3f)), 0.3f}); // from aside
    expect_lawful({panel, {0, -20, 0}, {0, 1, 0}, 0.03f}); // where area is sampled
});

const Test disk("law.emitter.disk.sampling_matches_density", [] {
    expect_lawful({ellipse, {0, 0, 0}, {0, 1, 0}, 0.6f});
    expect_lawful({ellipse, {0.4f, 0.9f, 0.1f}, {0, 1, 0}, 1.571f});
    expect_lawful({ellipse, {2.5f, 0.7f, 0.3f}, glm::normalize(vec3(-2.5f, 0.3f, -0.3f)), 0.3f});
    expect_lawful({ellipse, {0, -20, 0}, {0, 1, 0}, 0.03f});
});

const Test sphere("law.emitter.sphere.sampling_matches_density", [] {
    expect_lawful({scene::SphereLight{"", {0, 1, 0}, 0.3f, vec3(1.0f)}, {0, 0, 0}, {0, 1, 0}, 0.4f});
    expect_lawful({scene::SphereLight{"", {0, 1, 0}, 0.999f, vec3(1.0f)}, {0, 0, 0}, {0, 1, 0}, 1.571f});
    expect_lawful({scene::SphereLight{"", {0, 100, 0}, 0.01f, vec3(1.0f)}, {0, 0, 0}, {0, 1, 0}, 2e-4f});
});

const Test sun("law.emitter.sun.sampling_matches_density", [] {
    expect_lawful(
        {scene::DirectionalLight{"", {0, -1, 0}, vec3(1.0f), 0.00465f}, {0, 0, 0}, {0, 1, 0}, 0.006f});
    expect_lawful({scene::DirectionalLight{"", {0, -1, 0}, vec3(1.0f), 0.5f}, {0, 0, 0}, {0, 1, 0}, 0.6f});
});

const Test capsule("law.emitter.tube.sampling_matches_density", [] {
    expect_lawful({tube, {0, 0, 0}, {0, 1, 0}, 0.8f});
    expect_lawful({tube, {0.3f, 0.8f, 0.2f}, glm::normalize(vec3(-0.1f, 0.2f, -0.2f)), 1.571f});
    expect_lawful({tube, {2.5f, 1.0f, 0.3f}, glm::normalize(vec3(-2.5f, 0.0f, -0.3f)), 0.3f});
    expect_lawful({scene::TubeLight{"", {0, 1, 0}, {0, 0.3f, 0}, 0.2f, vec3(1.0f)},
                   {0.1f, 0, 0},
                   {0, 1, 0},
                   0.8f}); // end on
    expect_lawful({scene::TubeLight{"", {0, 1, 0}, {0.05f, 0, 0}, 0.3f, vec3(1.0f)},
                   {0, 0, 0},
                   {0, 1, 0},
                   0.6f}); // a ball
});

const Test polygon("law.emitter.polygon.sampling_matches_density", [] {
    expect_lawful({pentagon, {0, 0, 0}, {0, 1, 0}, 0.7f});
    expect_lawful({pentagon, {0.3f, 0.9f, 0.1f}, {0, 1, 0}, 1.571f});
    expect_lawful({pentagon, {2.5f, 0.7f, 0.3f}, glm::normalize(vec3(-2.5f, 0.3f, -0.3f)), 0.3f});
});

} // namespace
