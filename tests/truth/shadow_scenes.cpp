#include "truth/shadow_scenes.hpp"

#include "core/error.hpp"
#include "gltf/asset.hpp"
#include "scene/prepare.hpp"
#include "support/models.hpp"
#include "support/scenes.hpp"
#include "truth/scenes.hpp"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace sr::truth {
namespace {

using testing::add_box;
using testing::add_quad;

ShadowScene bundled(std::string_view name) {
    const auto file = testing::source_folder() / "assets/scenes" / fmt::format("{}.gltf", name);
    scene::RenderScene stage =
        scene::prepare_scene(gltf::load(file).scene, file.string(), {"", scene::Rig::none, 1.0f});
    return {gltf::load(file).scene, stage.camera};
}

scene::Camera looking(vec3 from, vec3 to, float yfov) {
    scene::Camera camera;
    camera.name = "view";
    camera.world_from_camera = glm::inverse(glm::lookAt(from, to, vec3(0, 1, 0)));
    camera.projection = scene::Perspective{yfov, std::nullopt, 0.01f, 100.0f};
    return camera;
}

scene::Material glossy(vec3 color, float metallic, float roughness) {
    scene::Material material;
    material.base_color = vec4(color, 1.0f);
    material.metallic = metallic;
    material.roughness = roughness;
    return material;
}

void add_floor(scene::Scene& scene, const scene::Material& material) {
    add_quad(scene, vec3(0.0f), vec3(0, 0, 4), vec3(4, 0, 0), material);
}

mat3 half_edges(vec3 e) { return {vec3(e.x, 0, 0), vec3(0, e.y, 0), vec3(0, 0, e.z)}; }

constexpr int bars = 8;

/// `bars` times nothing and a bar, along u; both halves equally wide.
scene::Material masked_bars(scene::Scene& scene, scene::Material material) {
    scene::TextureImage image{"bars", 2 * bars, 1, {}};
    auto& texels = image.texels.emplace<std::vector<std::uint8_t>>();
    for (int i = 0; i < 2 * bars; ++i)
        texels.insert(texels.end(), {255, 255, 255, static_cast<std::uint8_t>(i % 2 == 0 ? 0 : 255)});
    scene.images.push_back(image);
    scene::Texture texture;
    texture.sampler.wrap_u = texture.sampler.wrap_v = scene::Wrap::clamp_to_edge;
    scene.textures.push_back(texture);
    material.alpha_mode = scene::AlphaMode::mask;
    material.base_color_texture.texture = static_cast<int>(scene.textures.size()) - 1;
    return material;
}

/// A sheet above what the camera sees, whose bars the mask cuts where a filtered alpha passes one half: at
/// the border of two texels.
ShadowScene fence_under_a_disk(Fence fence) {
    ShadowScene s;
    add_floor(s.scene, glossy(vec3(0.7f, 0.6f, 0.5f), 0.0f, 0.5f));
    scene::Material board = testing::lambert(vec3(0.5f));
    board.is_double_sided = true;
    const vec3 center(0.0f, 0.8f, 0.0f), half_u(0, 0, 1.0f), half_v(1.0f, 0, 0);
    if (fence == Fence::masked) {
        add_quad(s.scene, center, half_u, half_v, masked_bars(s.scene, board));
    } else {
        for (int i = 0; i < bars; ++i) {
            const float at = (2.0f * static_cast<float>(2 * i) + 3.0f) / (2.0f * bars) - 1.0f;
            add_quad(s.scene, center + at * half_u, half_u / (2.0f * bars), half_v, board);
        }
    }
    s.scene.lights.push_back(scene::DiskLight{"disk",
                                              vec3(0.6f, 2.4f, 0.3f),
                                              vec3(0, 0, 0.25f),
                                              vec3(-0.25f, 0, 0),
                                              vec3(60.0f, 50.0f, 40.0f),
                                              false,
                                              true,
                                              {}});
    s.camera = looking(vec3(0.2f, 0.7f, 2.2f), vec3(0, 0, -0.1f), 0.7f);
    return s;
}

ShadowScene boxes_under_a_mesh() {
    ShadowScene s;
    add_floor(s.scene, testing::lambert(vec3(0.6f)));
    add_box(s.scene, vec3(-0.35f, 0.25f, 0.0f), half_edges(vec3(0.12f, 0.25f, 0.12f)), 1,
            glossy(vec3(0.2f, 0.5f, 0.8f), 0.0f, 0.4f));
    add_box(s.scene, vec3(0.4f, 0.1f, 0.3f), half_edges(vec3(0.2f, 0.1f, 0.1f)), 1,
            testing::lambert(vec3(0.8f, 0.4f, 0.2f)));
    add_octahedron(s.scene, vec3(0.1f, 1.0f, 0.1f), mat3(1.0f));
    s.camera = looking(vec3(0.3f, 1.0f, 2.0f), vec3(0, 0.15f, 0), 0.7f);
    return s;
}

ShadowScene ball_on_the_floor() {
    ShadowScene s;
    add_floor(s.scene, glossy(vec3(0.7f), 0.0f, 0.3f));
    add_box(s.scene, vec3(0.5f, 0.3f, -0.2f), half_edges(vec3(0.08f, 0.3f, 0.08f)), 1,
            testing::lambert(vec3(0.7f, 0.3f, 0.3f)));
    s.scene.lights.push_back(
        scene::SphereLight{"ball", vec3(-0.1f, 0.25f, 0.0f), 0.25f, vec3(10.0f, 9.0f, 7.0f), true});
    s.camera = looking(vec3(0.2f, 1.1f, 2.0f), vec3(0.15f, 0.1f, 0), 0.8f);
    return s;
}

} // namespace

ShadowScene shadow_scene(std::string_view name, Fence fence) {
    if (name == "fence") return fence_under_a_disk(fence);
    if (name == "mesh") return boxes_under_a_mesh();
    if (name == "ball") return ball_on_the_floor();
    return bundled(name);
}

} // namespace sr::truth
