#pragma once
// The χ² test of how a light is sampled: counts of directions in cells against the density's integral over
// them.
#include "render/gpu/gpu_scene.hpp"
#include "support/glsl_table.hpp"

#include <vector>

namespace sr::testing {

/// One light as the point x sees it, and the cone of directions that it is looked for in.
struct View {
    scene::Light light;
    vec3 x{0.0f};
    vec3 axis{0.0f, 1.0f, 0.0f};
    float cone = 0.0f; // half angle [rad], holds the whole light
};

/// Directions on a jittered grid in (1 - cosθ, φ), where areas are solid angles: in each row x, then the
/// direction.
std::vector<Row> grid(const View& view);

/// Draws samples and holds their counts to the densities (.x, [1/sr]) on the grid: Pearson's statistic stays
/// within five of its standard deviations. @return the samples: direction, and p as sample_light tells it
std::vector<vec4> expect_counts(const View& view, const render::GpuScene& scene,
                                const std::vector<vec4>& densities);

} // namespace sr::testing
