#include "brdf/sphere.hpp"

#include "render/renderer.hpp"

#include <cmath>

namespace sr::brdf {
namespace {

constexpr int meridians = 128, parallels = 64;

scene::Mesh ball() {
    scene::Mesh mesh;
    for (int i = 0; i <= parallels; ++i)
        for (int j = 0; j <= meridians; ++j) {
            const float theta = pi * static_cast<float>(i) / parallels,
                        phi = 2.0f * pi * static_cast<float>(j) / meridians;
            const vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            mesh.positions.push_back(n);
            mesh.normals.push_back(n);
            mesh.tangents.emplace_back(std::cos(phi), 0.0f, -std::sin(phi), 1.0f);
        }
    for (int i = 0; i < parallels; ++i)
        for (int j = 0; j < meridians; ++j) {
            const auto a = static_cast<std::uint32_t>(i * (meridians + 1) + j), b = a + meridians + 1;
            for (const std::uint32_t index : {a, b, b + 1, a, b + 1, a + 1}) mesh.indices.push_back(index);
        }
    return mesh;
}

} // namespace

image::Image lit_sphere(const Specimen& specimen, int size, int samples) {
    scene::Scene scene;
    scene.materials.push_back(specimen.material);
    scene.measured = specimen.measured;
    scene.meshes.push_back(ball());
    scene.instances.push_back({0, mat4(1.0f), "ball"});
    const std::vector<scene::Light> lights{
        scene::RectangleLight{
            "softbox", {-3.0f, 3.0f, 3.0f}, {0.9f, 0.0f, 0.9f}, {0.45f, 0.9f, -0.45f}, vec3(400.0f)},
        scene::RectangleLight{
            "strip", {4.0f, 0.5f, 2.0f}, {-0.1f, 0.0f, 0.2f}, {0.0f, 1.5f, 0.0f}, vec3(400.0f)},
        scene::PointLight{"point", {0.5f, 5.0f, 4.0f}, vec3(2500.0f)}};
    scene::Camera camera;
    camera.world_from_camera[3] = vec4(0.0f, 0.0f, 5.0f, 1.0f);
    camera.projection = scene::Perspective{0.46f, 1.0f, 0.1f, {}};

    const render::GpuScene gpu_scene(scene, lights, render::Visibility::none,
                                     specimen.has_energy_compensation);
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.background = vec3(2.0f);
    options.shader_path = overlay_path(specimen);
    options.trial = specimen.trial;
    render::Renderer renderer(gpu_scene, camera, options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return renderer.film();
}

} // namespace sr::brdf
