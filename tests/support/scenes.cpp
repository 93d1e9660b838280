#include "support/scenes.hpp"

#include "support/gl.hpp"

#include <algorithm>
#include <cmath>

namespace sr::testing {

scene::Scene lambert_plane(float half_edge, vec3 rho) {
    scene::Scene scene;
    scene::Material material;
    material.base_color = vec4(rho, 1.0f);
    material.metallic = 0.0f;
    material.specular = 0.0f; // KHR_materials_specular: nothing but the diffuse part is left
    scene.materials.push_back(material);
    scene::Mesh mesh;
    mesh.name = "plane";
    const float e = half_edge;
    mesh.positions = {{-e, 0.0f, e}, {e, 0.0f, e}, {e, 0.0f, -e}, {-e, 0.0f, -e}};
    mesh.normals.assign(4, vec3(0.0f, 1.0f, 0.0f));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({0, mat4(1.0f), "plane"});
    return scene;
}

scene::Camera camera_from_above(float half_extent) {
    scene::Camera camera;
    camera.name = "above";
    // Right is +X, up in the picture is -Z, so that the camera looks along -Y.
    camera.world_from_camera = mat4(vec4(1, 0, 0, 0), vec4(0, 0, -1, 0), vec4(0, 1, 0, 0), vec4(0, 10, 0, 1));
    camera.projection = scene::Orthographic{half_extent, half_extent, 0.1f, 20.0f};
    return camera;
}

vec2 place_of(int column, int row, int size, float half_extent) {
    const vec2 st = (vec2(column, row) + 0.5f) / static_cast<float>(size);
    return (2.0f * st - 1.0f) * half_extent;
}

image::Image picture(const scene::Scene& scene, std::span<const scene::Light> lights,
                     const scene::Camera& camera, int size, int samples, std::uint32_t seed) {
    context();
    const render::GpuScene gpu_scene(scene, lights);
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.seed = seed;
    render::Renderer renderer(gpu_scene, camera, options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return renderer.film();
}

float largest_relative_difference(const image::Image& a, const image::Image& b, float floor) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        if (i % 4 == 3) continue;
        const float difference = std::abs(a.pixels[i] - b.pixels[i]) / std::max(std::abs(b.pixels[i]), floor);
        largest = std::max(largest, std::isnan(difference) ? INFINITY : difference);
    }
    return largest;
}

} // namespace sr::testing
