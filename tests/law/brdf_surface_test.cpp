#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

/// A mirror of reflectance 0.8 in y = 0 under a square of radiance L = 5 at height 1 that faces down.
image::Image mirrored(std::vector<scene::Light> lights) {
    scene::Scene scene = lambert_plane(4.0f, vec3(0.8f));
    scene.materials[0].model = scene::Model::mirror;
    return picture(scene, lights, camera_from_above(1.0f), 32, 4, 0, render::Visibility::none);
}

// The camera looks along the normal, so each pixel sees the point of the emitter that is straight above it: ρ
// L, to the last digits and without noise, and black beside it.
const Test mirror("law.brdf.mirror.shows_the_emitter", [] {
    const auto film =
        mirrored({scene::RectangleLight{"", {0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, vec3(5.0f)}});
    for (int row = 0; row < 32; ++row)
        for (int column = 0; column < 32; ++column) {
            const vec2 place = glm::abs(place_of(column, row, 32, 1.0f));
            const float off = std::max(place.x, place.y) - 0.5f;
            if (std::abs(off) < 0.05f) continue;
            EXPECT_NEAR(film.at(column, row)[0], off < 0.0f ? 4.0f : 0.0f, 1e-4f);
        }
    const auto point = mirrored({scene::PointLight{"", {0, 1, 0}, vec3(100.0f)}});
    EXPECT_EQ(point.at(16, 16)[0], 0.0f) << "a point has no extent to be seen";
});

// A normal map bends n by 60° towards +x all over a plane. Light from above reaches it with n's cosine. Light
// from below, which would still be above n, does not come through.
const Test leak("law.surface.normal_map.lets_no_light_through_from_behind", [] {
    scene::Scene scene = lambert_plane(4.0f);
    scene::TextureImage image{"bent", 1, 1,
                              std::vector<std::uint8_t>{238, 128, 191, 255}}; // (sin 60°, 0, cos 60°)
    scene.images.push_back(image);
    scene.textures.push_back({0, {}, scene::ColorSpace::linear});
    scene.materials[0].normal_texture.texture = 0;
    scene.meshes[0].texcoords[0].assign(scene.meshes[0].positions.size(), vec2(0.0f));
    scene.meshes[0].tangents.assign(scene.meshes[0].positions.size(), vec4(1, 0, 0, 1));
    const auto lit_from = [&](vec3 w) { // a directional light of 1 lx
        return picture(scene,
                       std::vector<scene::Light>{scene::DirectionalLight{"", -glm::normalize(w), vec3(1.0f)}},
                       camera_from_above(1.0f), 4, 1, 0, render::Visibility::none)
            .at(2, 2)[0];
    };
    EXPECT_NEAR(lit_from({0, 1, 0}) * pi, 0.5f, 0.01f);
    EXPECT_NEAR(lit_from({std::sqrt(3.0f), 1, 0}) * pi, 1.0f, 0.01f); // along n
    EXPECT_NEAR(lit_from({1, 0.02f, 0}) * pi, 0.87f, 0.02f); // grazing the plane, not n: no black fringe
    EXPECT_EQ(lit_from({1, -0.02f, 0}), 0.0f);
    EXPECT_EQ(lit_from({0.9f, -0.4f, 0}), 0.0f);
});

// KHR_materials_pbrSpecularGlossiness along the normal, where wi = wo = h = n: D = 1/(π α²), V = 1/4, F = F0,
// and f_r = (1 - max F0) diffuse (1 - max F0) / π + F0 / (4 π α²), α = (1 - glossiness)².
const Test glossiness("law.surface.specular_glossiness.is_diffuse_and_F0", [] {
    scene::Scene scene = lambert_plane(4.0f);
    scene.images.push_back({"", 1, 1, std::vector<std::uint8_t>{255, 188, 0, 128}});
    scene.textures.push_back({0, {}, scene::ColorSpace::srgb});
    scene::Material& m = scene.materials[0];
    m = {};
    m.is_specular_glossiness = true;
    m.metallic = m.ior = m.roughness = 0.0f;
    m.base_color = vec4(0.9f, 0.6f, 0.3f, 1.0f);
    m.specular_color = vec3(0.25f, 0.5f, 0.75f);
    scene.meshes[0].texcoords[0].assign(scene.meshes[0].positions.size(), vec2(0.0f));
    const auto expect = [&](vec3 F0, float glossiness) {
        const std::vector<scene::Light> lights{
            scene::DirectionalLight{"", {0, -1, 0}, vec3(1.0f)}}; // of 1 lx
        const auto film =
            picture(scene, lights, camera_from_above(0.001f), 4, 1, 0, render::Visibility::none);
        const float left = 1.0f - std::max(F0.x, std::max(F0.y, F0.z));
        const float alpha = (1.0f - glossiness) * (1.0f - glossiness);
        for (int c = 0; c < 3; ++c) {
            const float f_r = left * left * m.base_color[c] / pi + F0[c] / (4.0f * pi * alpha * alpha);
            EXPECT_NEAR(film.at(2, 2)[c] / f_r, 1.0f, 1e-3f) << c;
        }
    };
    m.roughness = 0.5f;
    expect(m.specular_color, 0.5f);
    m.roughness = 0.25f; // the factor of the glossiness is 0.75
    m.specular_color_texture.texture = 0;
    expect(m.specular_color * vec3(1.0f, 0.502886f, 0.0f), 0.75f * 128.0f / 255.0f);
});

} // namespace
