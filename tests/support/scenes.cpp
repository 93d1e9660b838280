#include "support/scenes.hpp"

#include "support/gl.hpp"

#include <algorithm>
#include <cmath>

namespace sr::testing {

scene::Material lambert(vec3 rho) {
    scene::Material material;
    material.base_color = vec4(rho, 1.0f);
    material.metallic = 0.0f;
    material.specular = 0.0f; // KHR_materials_specular: nothing but the diffuse part is left
    return material;
}

scene::Scene lambert_plane(float half_edge, vec3 rho) {
    scene::Scene scene;
    scene.materials.push_back(lambert(rho));
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

scene::Instance& add_quad(scene::Scene& scene, vec3 center, vec3 half_u, vec3 half_v,
                          const scene::Material& material) {
    scene::Mesh mesh;
    mesh.positions = {center - half_u - half_v, center + half_u - half_v, center + half_u + half_v,
                      center - half_u + half_v};
    mesh.normals.assign(4, glm::normalize(glm::cross(half_u, half_v)));
    mesh.texcoords[0] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene.meshes.push_back(mesh);
    return scene.instances.emplace_back(
        scene::Instance{static_cast<int>(scene.meshes.size()) - 1, mat4(1.0f), "quad"});
}

void add_box(scene::Scene& scene, vec3 center, const mat3& half_axes, int cells,
             const scene::Material& material) {
    scene::Mesh mesh;
    const auto face = [&](int axis, float side) {
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        const int u = (axis + (side > 0.0f ? 1 : 2)) % 3, v = (axis + (side > 0.0f ? 2 : 1)) % 3;
        for (int j = 0; j <= cells; ++j) {
            for (int i = 0; i <= cells; ++i) {
                vec3 p(0.0f);
                p[axis] = side;
                p[u] = 2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1.0f;
                p[v] = 2.0f * static_cast<float>(j) / static_cast<float>(cells) - 1.0f;
                mesh.positions.push_back(center + half_axes * p);
                mesh.normals.push_back(glm::normalize(side * half_axes[axis]));
            }
        }
        for (int j = 0; j < cells; ++j) {
            for (int i = 0; i < cells; ++i) {
                const std::uint32_t row = static_cast<std::uint32_t>(cells) + 1;
                const std::uint32_t a =
                    base + static_cast<std::uint32_t>(j) * row + static_cast<std::uint32_t>(i);
                mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
            }
        }
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) face(axis, side);
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene.meshes.push_back(mesh);
    scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, mat4(1.0f), "box"});
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
                     const scene::Camera& camera, int size, int samples, std::uint32_t seed,
                     render::Visibility visibility) {
    context();
    const render::GpuScene gpu_scene(scene, lights, visibility);
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.seed = seed;
    options.maps.size = 256; // quick, and enough for pictures so small
    render::Renderer renderer(gpu_scene, camera, options);
    for (int i = 0; i < samples; ++i) renderer.add_sample();
    return renderer.read_film();
}

float max_relative_difference(const image::Image& a, const image::Image& b, float floor) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        if (i % 4 == 3) continue;
        const float difference = std::abs(a.pixels[i] - b.pixels[i]) / std::max(std::abs(b.pixels[i]), floor);
        largest = std::max(largest, std::isnan(difference) ? INFINITY : difference);
    }
    return largest;
}

} // namespace sr::testing
