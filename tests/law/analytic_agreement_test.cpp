// The two estimators are two ways to one integral: what the closed forms do not reach is held to the samples.
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int size = 16;

/// Glossy plastic, and above it a texture of two colours and gaps.
scene::Scene glossy_plane() {
    scene::Scene scene = lambert_plane(4.0f, vec3(0.5f));
    scene.materials[0].specular = 1.0f;
    scene.materials[0].roughness = 0.5f;
    scene::TextureImage image;
    image.width = image.height = 2;
    image.texels =
        std::vector<std::uint8_t>{255, 128, 0, 255, 0, 0, 0, 255, 64, 64, 255, 255, 255, 255, 255, 255};
    scene.images.push_back(image);
    scene.textures.push_back({0, {}, scene::ColorSpace::linear});
    return scene;
}

image::Image rendered(const render::GpuScene& scene, render::Estimator estimator, int samples) {
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.estimator = estimator;
    scene::Camera camera = camera_from_above(2.0f);
    render::Renderer renderer(scene, camera, options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return renderer.read_film();
}

/// The pictures' sums agree within `of_sum`, their pixels in the mean within `of_pixel`.
void expect_agreement(const scene::Scene& scene, const scene::Light& light, double of_sum, double of_pixel,
                      render::Visibility visibility = render::Visibility::none) {
    context();
    const std::vector<scene::Light> lights{light};
    const render::GpuScene gpu_scene(scene, lights, visibility);
    const auto sampled = rendered(gpu_scene, render::Estimator::sampled, 1024);
    const auto analytic = rendered(gpu_scene, render::Estimator::analytic, 64);
    double sum = 0.0, expected = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < sampled.pixels.size(); ++i) {
        if (i % 4 == 3) continue;
        sum += analytic.pixels[i];
        expected += sampled.pixels[i];
        difference += std::abs(analytic.pixels[i] - sampled.pixels[i]);
    }
    EXPECT_GT(expected, 0.0);
    EXPECT_NEAR(sum / expected, 1.0, of_sum);
    EXPECT_LE(difference / expected, of_pixel);
}

const Test textured("law.integrator.analytic.textured_rectangle", [] {
    scene::RectangleLight light{"", {0, 0.8f, 0}, {0.7f, 0, 0}, {0, 0, 0.7f}, vec3(3.0f)};
    light.map.texture = 0;
    expect_agreement(glossy_plane(), light, 0.02, 0.05);
});

const Test round_spot("law.integrator.analytic.spot_with_a_radius", [] {
    scene::SpotLight light;
    light.position = {0.2f, 1.2f, 0};
    light.direction = {0, -1, 0};
    light.outer_angle = 0.6f;
    light.radius = 0.2f;
    expect_agreement(glossy_plane(), light, 0.02, 0.05);
});

const Test many_triangles("law.integrator.analytic.mesh_of_many_triangles_is_sampled", [] {
    scene::MeshLight light;
    for (int k = 0; k < render::max_outlined_triangles + 8; ++k) {
        const float x = 0.25f * static_cast<float>(k % 8) - 1.0f,
                    z = 0.25f * static_cast<float>(k / 8) - 0.6f;
        light.triangles.push_back({{vec3(x, 1, z), vec3(x + 0.2f, 1, z), vec3(x, 1, z + 0.2f)}, {}});
    }
    expect_agreement(glossy_plane(), light, 0.01, 0.03);
});

const Test shadow("law.integrator.analytic.shadow_of_a_square", [] {
    scene::Scene scene = glossy_plane();
    scene::Mesh square = scene.meshes.front();
    for (vec3& p : square.positions) p = vec3(0.1f * p.x + 0.3f, 0.5f, 0.1f * p.z);
    scene.meshes.push_back(square);
    scene.materials[0].is_double_sided = true;
    scene.instances.push_back({1, mat4(1.0f), "square"});
    const scene::RectangleLight light{"", {0, 1.5f, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}, vec3(3.0f)};
    expect_agreement(scene, light, 0.01, 0.02, render::Visibility::ray);
});

} // namespace
