// Metalness and roughness in the alphas of other textures: which materials have them there, and that pictures
// show it nowhere.
#include "render/gpu/texture_packing.hpp"

#include "gl/context.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <array>
#include <functional>
#include <utility>

using namespace sr;
using namespace sr::testing;
using render::PackedAlpha;
using render::TexturePacking;

namespace {

constexpr int size = 32;

/// Texels whose channels change in ways of their own.
scene::TextureImage image(int seed, int width = size) {
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < width; ++x)
            for (const int channel :
                 {128 + (seed * x + y) % 60, 200 - (x + seed * y) % 90, 160 + (x * y + seed) % 90, 255})
                texels.push_back(static_cast<std::uint8_t>(channel));
    return {"image", width, size, texels};
}

/// Textures 0, 1 and 2 are the base colour, the normal map, and metalness with roughness. 3, 4 and 5 are
/// others of the same kinds.
scene::Scene textured() {
    scene::Scene scene;
    for (int i = 0; i < 6; ++i) {
        scene.images.push_back(image(1 + i));
        scene.textures.push_back({i, {}, i % 3 == 0 ? scene::ColorSpace::srgb : scene::ColorSpace::linear});
    }
    scene::Material material;
    material.base_color_texture = {0, 0};
    material.normal_texture = {1, 0};
    material.metallic_roughness_texture = {2, 0};
    add_quad(scene, {}, {1, 0, 0}, {0, 0, -1}, material);
    scene.meshes[0].tangents.assign(4, vec4(1, 0, 0, 1));
    scene.meshes[0].texcoords[0] = {{0, 0}, {1.3f, 0}, {1.3f, 1.6f}, {0, 1.6f}};
    return scene;
}

TexturePacking packing_with(const std::function<void(scene::Scene&, scene::Material&)>& change) {
    scene::Scene scene = textured();
    change(scene, scene.materials[0]);
    return render::pack_textures(scene, true);
}

const Test packed("unit.render.texture_packing.metalness_and_roughness_lie_in_spare_alphas", [] {
    const TexturePacking packing = packing_with([](scene::Scene&, scene::Material&) {});
    EXPECT_TRUE(packing.packs(0));
    EXPECT_FALSE(packing.packs(1)) << "a material that came later";
    EXPECT_EQ(packing.alpha_from[0], (PackedAlpha{2, 1})) << "roughness is green";
    EXPECT_EQ(packing.alpha_from[1], (PackedAlpha{2, 2})) << "metalness is blue";
    EXPECT_FALSE(packing.is_needed[2]);
    EXPECT_TRUE(packing.is_needed[0] && packing.is_needed[1] && packing.is_needed[3]);
    EXPECT_FALSE(render::pack_textures(textured(), false).packs(0));
});

const Test kept("unit.render.texture_packing.what_is_not_alike_stays_apart", [] {
    using M = scene::Material;
    using S = scene::Scene;
    const std::vector<std::pair<std::string, std::function<void(S&, M&)>>> changes{
        {"alpha is read", [](S&, M& m) { m.alpha_mode = scene::AlphaMode::blend; }},
        {"alpha is compared", [](S&, M& m) { m.alpha_mode = scene::AlphaMode::mask; }},
        {"glass", [](S&, M& m) { m.metallic = 0.5f, m.transmission = 0.5f; }},
        {"specular and glossiness", [](S&, M& m) { m.is_specular_glossiness = true; }},
        {"no normal map", [](S&, M& m) { m.normal_texture = {}; }},
        {"no base colour", [](S&, M& m) { m.base_color_texture = {}; }},
        {"another size", [](S& s, M&) { s.images[2] = image(3, 16); }},
        {"another sampler", [](S& s, M&) { s.textures[2].sampler.wrap_u = scene::Wrap::clamp_to_edge; }},
        {"another set", [](S&, M& m) { m.metallic_roughness_texture.texcoord = 1; }},
        {"another transform", [](S&, M& m) { m.base_color_texture.uv_transform[2][0] = 0.5f; }},
        {"codes of 16 bits",
         [](S& s, M&) { s.images[1].texels = std::vector<std::uint16_t>(4 * size * size, 40000); }},
    };
    for (const auto& [what, change] : changes) {
        const TexturePacking packing = packing_with(change);
        EXPECT_FALSE(packing.packs(0)) << what;
        EXPECT_EQ(packing.alpha_from, std::vector<PackedAlpha>(6)) << what;
        EXPECT_TRUE(packing.is_needed[2]) << what;
    }
});

// An alpha has one source, so materials that share a texture have to agree on it, and those that share others
// with them.
const Test shared("unit.render.texture_packing.materials_that_share_a_texture_agree", [] {
    const auto packs = [](const std::vector<std::array<int, 3>>& textures) {
        scene::Scene scene = textured();
        const scene::Material first = scene.materials[0];
        scene.materials.clear();
        for (const auto& [base, normal, metallic_roughness] : textures) {
            scene::Material& material = scene.materials.emplace_back(first);
            material.base_color_texture.texture = base;
            material.normal_texture.texture = normal;
            material.metallic_roughness_texture.texture = metallic_roughness;
        }
        return render::pack_textures(scene, true).is_packed;
    };
    using Packed = std::vector<bool>;
    EXPECT_EQ(packs({{0, 1, 2}, {0, 1, 2}}), (Packed{true, true}));
    EXPECT_EQ(packs({{0, 1, 2}, {3, 4, 5}}), (Packed{true, true}));
    EXPECT_EQ(packs({{0, 1, 2}, {0, 4, 5}}), (Packed{false, false}));
    EXPECT_EQ(packs({{0, 1, 2}, {0, -1, -1}}), (Packed{false, false})) << "the second one's alpha is 1";
    EXPECT_EQ(packs({{0, 1, 2}, {0, 4, 5}, {3, 4, 5}}), (Packed{false, false, false}))
        << "one after the other";
    EXPECT_EQ(packs({{0, 1, 2}, {-1, 4, 2}}), (Packed{true, false}))
        << "who reads the image itself, disturbs nobody";
});

image::Image film_of(const scene::Scene& scene, render::TextureChannels channels) {
    const std::vector<scene::Light> lights{
        scene::PointLight{"", {0.3f, 1.0f, 0.5f}, vec3(3.0f)},
        scene::RectangleLight{"", {-0.5f, 1.5f, 0}, {0.4f, 0, 0}, {0, 0, 0.4f}, vec3(8.0f)}};
    const render::GpuScene gpu_scene(scene, lights, render::Visibility::none, false, channels);
    EXPECT_EQ(gpu_scene.opaque_draws()[0].features.has_packed_metallic_roughness,
              channels == render::TextureChannels::in_use);
    render::RenderOptions options;
    options.width = options.height = 40;
    render::Renderer renderer(gpu_scene, camera_from_above(1.1f), options);
    for (int i = 0; i < 4; ++i) renderer.add_sample();
    return renderer.read_film();
}

const Test equal("unit.render.texture_packing.pictures_stay_the_same", [] {
    context();
    if (!gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER))))
        GTEST_SKIP() << "this driver filters 8 bits exactly, and gets them";
    const scene::Scene scene = textured();
    const image::Image apart = film_of(scene, render::TextureChannels::all),
                       packed = film_of(scene, render::TextureChannels::in_use);
    // Half floats hold the means of roughness of the mip levels, whose steps are 2^-11 of them.
    EXPECT_LT(max_relative_difference(packed, apart, 1e-2f), 2e-3f);
    scene::Scene other = scene;
    other.images[2] = image(40);
    EXPECT_GT(max_relative_difference(film_of(other, render::TextureChannels::in_use), apart, 1e-2f), 0.05f)
        << "they are read";
});

} // namespace
