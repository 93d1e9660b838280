#include "law/direction_counts.hpp"
#include "scene/prepare.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

scene::EnvironmentLight with(std::vector<vec3> texels, int width, float rotation = 0.0f) {
    const int height = static_cast<int>(texels.size()) / width;
    scene::EnvironmentLight light;
    light.map = std::make_shared<const scene::EnvironmentMap>(width, height, std::move(texels));
    light.rotation = rotation;
    return light;
}

/// Uneven, with black parts and one texel far brighter than all others.
scene::EnvironmentLight uneven(float hottest) {
    std::vector<vec3> texels;
    for (int i = 0; i < 12 * 6; ++i) texels.emplace_back(i % 5 < 3 ? 0.0f : 0.3f * static_cast<float>(i % 7));
    texels[27] = vec3(hottest);
    return with(texels, 12, 0.7f);
}

void expect_lawful_light(const scene::EnvironmentLight& light) {
    context();
    const View view{light, {0, 0, 0}, glm::normalize(vec3(0.3f, 0.8f, -0.5f)), pi};
    const scene::Scene nothing;
    const render::GpuScene scene(nothing, std::vector{view.light});
    expect_counts(view, scene,
                  evaluate("#include \"light/sample_light.glsl\"",
                           "return vec4(light_along(0, a.xyz, b.xyz).p, 0.0, 0.0, 0.0);", grid(view),
                           &scene));
}

const Test sampling("law.emitter.environment.sampling_matches_density", [] {
    expect_lawful_light({});
    expect_lawful_light(uneven(4.0f));
    expect_lawful_light(scene::studio(scene::Camera{}));
});

// The shader's radiance and density are those of the Scene's own evaluation.
const Test twin("law.emitter.environment.is_the_scenes_own", [] {
    context();
    const scene::EnvironmentLight light = uneven(1e9f);
    const scene::Scene nothing;
    const std::vector<scene::Light> lights{light};
    const render::GpuScene scene(nothing, lights);
    const std::vector<Row> rows = grid({light, {0, 0, 0}, {0, 1, 0}, pi});
    const auto values = evaluate(
        "#include \"light/sample_light.glsl\"",
        "LightSample s = light_along(0, a.xyz, b.xyz); return vec4(s.Li_over_p * s.p, s.p);", rows, &scene);
    int wrong = 0;
    for (std::size_t i = 0; i < rows.size(); i += 17) {
        const vec3 w(rows[i][1]);
        const float L = light.radiance(w).g;
        const double p = light.map->density(light.map_from_world() * w);
        wrong +=
            std::abs(values[i].y - L) > 1e-3f * L + 1e-3f || std::abs(values[i].w - p) > 1e-3 * p + 1e-12;
    }
    EXPECT_LE(wrong, 20) << "on the very edges of texels";
});

/// The mean of a picture's red channel over the plane, which looks at the origin alone.
double plane_under(const scene::EnvironmentLight& light, render::Visibility visibility, int samples) {
    const auto image = picture(lambert_plane(1.0f), std::vector<scene::Light>{light},
                               camera_from_above(1e-6f), 16, samples, 0, visibility);
    double sum = 0.0;
    for (int i = 0; i < 16 * 16; ++i) {
        EXPECT_TRUE(std::isfinite(image.pixels[static_cast<std::size_t>(4 * i)]));
        sum += image.pixels[static_cast<std::size_t>(4 * i)];
    }
    return sum / 256.0;
}

// E = π L: white Lambert reads L.
const Test furnace("law.emitter.environment.furnace", [] {
    scene::EnvironmentLight light;
    light.L = vec3(3.0f);
    EXPECT_NEAR(plane_under(light, render::Visibility::none, 256) / 3.0, 1.0, 2e-3);
    EXPECT_NEAR(plane_under(light, render::Visibility::ray, 256) / 3.0, 1.0, 2e-3);
    EXPECT_NEAR(plane_under(with(std::vector<vec3>(32, vec3(1.0f)), 8), render::Visibility::ray, 256), 1.0,
                2e-3);
});

// E of a map, by the midpoints of a fine grid over its hemisphere; a texel of 10^9 neither burns nor
// vanishes.
const Test hot("law.emitter.environment.a_hot_texel_is_sampled_not_clamped", [] {
    for (const float hottest : {2.0f, 1e4f, 1e9f}) {
        const scene::EnvironmentLight light = uneven(hottest);
        double E = 0.0;
        constexpr int rings = 600, sectors = 1200;
        for (int r = 0; r < rings; ++r)
            for (int s = 0; s < sectors; ++s) {
                const double y = (r + 0.5) / rings, phi = 2.0 * pi * (s + 0.5) / sectors,
                             across = std::sqrt(1.0 - y * y);
                E += light.radiance(vec3(across * std::cos(phi), y, across * std::sin(phi))).r * y * 2.0 * pi
                     / (rings * sectors);
            }
        EXPECT_NEAR(plane_under(light, render::Visibility::ray, 512) * pi / E, 1.0, 5e-3) << hottest;
    }
});

const Test white("law.emitter.environment.white_is_1_under_the_studio", [] {
    const scene::EnvironmentLight studio = scene::studio(scene::Camera{});
    const vec3 n = glm::normalize(vec3(0.0f, 0.35f, 1.0f));
    double E = 0.0;
    constexpr int rows = 300, columns = 600;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const double y = 2.0 * (j + 0.5) / rows - 1.0, phi = 2.0 * pi * (i + 0.5) / columns,
                         across = std::sqrt(1.0 - y * y);
            const vec3 w(across * std::cos(phi), y, across * std::sin(phi));
            E += std::max(glm::dot(n, w), 0.0f) * studio.radiance(w).g * 4.0 * pi / (rows * columns);
        }
    EXPECT_NEAR(E / pi, 1.0, 0.01);
});

} // namespace
