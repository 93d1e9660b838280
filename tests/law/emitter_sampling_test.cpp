#include "law/direction_counts.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"

#include <cmath>
#include <fmt/format.h>

using namespace sr;
using namespace sr::testing;

namespace {

std::vector<vec4> densities_along(const std::vector<Row>& rows, const render::GpuScene& scene) {
    return evaluate("#include \"light/sample_light.glsl\"",
                    "return vec4(light_along(0, a.xyz, b.xyz).p, 0.0, 0.0, 0.0);", rows, &scene);
}

void expect_lawful(const View& view) {
    SCOPED_TRACE(fmt::format("from ({}, {}, {})", view.x.x, view.x.y, view.x.z));
    context();
    const scene::Scene nothing;
    const render::GpuScene scene(nothing, std::vector{view.light});
    const auto samples = expect_counts(view, scene, densities_along(grid(view), scene));

    std::vector<Row> again;
    for (std::size_t i = 0; i < 4096; ++i)
        again.push_back({vec4(view.x, 0.0f), vec4(vec3(samples[i]), 0.0f)});
    const auto backwards = densities_along(again, scene);
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

const Test disk_directions("law.emitter.disk.sampling_matches_density", [] {
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

const Test sun_directions("law.emitter.sun.sampling_matches_density", [] {
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

/// The density of directions under a mesh, in doubles: P_i / Ω_i, or P_i d² / (A_i cosθ) below mesh.glsl's
/// 0.01 sr.
double mesh_density(const scene::MeshLight& light, glm::dvec3 w) {
    double p = 0.0;
    for (const auto& [corners, uv] : light.triangles) {
        const glm::dvec3 a = corners[0], b = corners[1], c = corners[2];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double volume = std::abs(glm::dot(a, normal));
        if (glm::dot(glm::cross(a, b), w) > 0.0 || glm::dot(glm::cross(b, c), w) > 0.0
            || glm::dot(glm::cross(c, a), w) > 0.0)
            continue; // beside it: seen from its front, corners go round against w
        const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
        const double solid_angle = 2.0
                                   * std::atan2(volume, la * lb * lc + glm::dot(a, b) * lc
                                                            + glm::dot(b, c) * la + glm::dot(c, a) * lb);
        const double d = glm::dot(a, normal) / glm::dot(w, normal);
        const double P = 0.5 * glm::length(normal) / light.area();
        p += P * (solid_angle > 0.01 ? 1.0 / solid_angle : 2.0 * d * d * d / volume);
    }
    return p;
}

// Triangles of many sizes and distances, chosen by area, some seen large, some small.
const Test mesh("law.emitter.mesh.sampling_matches_density", [] {
    context();
    scene::MeshLight light;
    const auto add = [&](vec3 a, vec3 b, vec3 c) { light.triangles.push_back({{a, b, c}, {}}); };
    add({-0.6f, 0.8f, -0.4f}, {-0.1f, 0.8f, -0.4f}, {-0.6f, 0.9f, 0.3f});
    add({0.0f, 1.0f, 0.1f}, {0.05f, 1.0f, 0.1f}, {0.0f, 1.1f, 0.2f});
    add({0.3f, 1.5f, -0.6f}, {0.9f, 1.2f, -0.5f}, {0.6f, 1.4f, 0.2f});
    add({0.2f, 2.0f, 0.5f}, {0.3f, 2.0f, 0.5f}, {0.25f, 2.0f, 0.6f});
    const View view{light, {0, 0, 0}, {0, 1, 0}, 0.9f};
    const scene::Scene nothing;
    const render::GpuScene scene(nothing, std::vector{view.light});
    std::vector<vec4> densities;
    for (const Row& row : grid(view))
        densities.emplace_back(mesh_density(light, vec3(row[1])), 0.0f, 0.0f, 0.0f);
    expect_counts(view, scene, densities);
});

} // namespace
