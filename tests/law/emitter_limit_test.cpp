#include "support/address.hpp"
#include "support/scenes.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int coarse_size = 17;
constexpr float near_extent = 1.0f;

image::Image lit_by(const scene::Light& light, int samples,
                    scene::Scene scene = lambert_plane(2.0f * near_extent)) {
    const std::vector<scene::Light> lights{light};
    return picture(scene, lights, camera_from_above(near_extent), coarse_size, samples);
}

void expect_equal(const scene::Light& a, const scene::Light& b, float tolerance, int samples = 64) {
    EXPECT_LT(max_relative_difference(lit_by(a, samples), lit_by(b, samples), 1e-4f), tolerance);
}

// The smaller an emitter, the less its shape matters: I = L A for a disk (times its cosine) and L π r² for a
// ball.
const Test ball("law.emitter.sphere.small_is_a_point", [] {
    const float r = 0.01f, L = 1000.0f;
    expect_equal(scene::SphereLight{"", {0.1f, 1, 0}, r, vec3(L)},
                 scene::PointLight{"", {0.1f, 1, 0}, vec3(L * pi * r * r)}, 1e-3f);
});

const Test disk("law.emitter.disk.small_is_a_point_on_its_axis", [] {
    const float r = 0.01f;
    const scene::DiskLight light{"", {0, 1, 0}, {r, 0, 0}, {0, 0, r}, vec3(1000.0f)};
    const auto image = lit_by(light, 1); // at the pixel's centre
    EXPECT_NEAR(image.at(coarse_size / 2, coarse_size / 2)[0], 1000.0f * r * r, 1e-3f * 1000.0f * r * r);
});

const Test bulb("law.emitter.point.a_radius_keeps_its_intensity", [] {
    scene::PointLight point{"", {0.1f, 1, 0}, vec3(3.0f)};
    point.range = 3.0f;
    scene::PointLight round = point;
    round.radius = 0.01f;
    expect_equal(round, point, 2e-3f);
});

const Test lamp("law.emitter.spot.a_radius_keeps_its_cone", [] {
    scene::SpotLight spot{"", {0.1f, 1, 0}, {0, -1, 0}, vec3(3.0f)};
    spot.inner_angle = 0.2f;
    spot.outer_angle = 0.9f;
    scene::SpotLight round = spot;
    round.radius = 0.001f;
    expect_equal(round, spot, 0.03f); // at the cone's edge the falloff is steep against the radius
});

const Test sun("law.emitter.sun.a_small_disk_is_parallel_light", [] {
    scene::DirectionalLight parallel{"", {-0.6f, -0.8f, 0}, vec3(3.0f)};
    scene::DirectionalLight round = parallel;
    round.angular_radius = 0.00465f;
    expect_equal(round, parallel, 1e-4f);
});

const Test plates("law.emitter.polygon.of_four_corners_is_a_rectangle", [] {
    const scene::RectangleLight rectangle{"", {0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.3f}, vec3(2.0f)};
    const scene::PolygonLight polygon{
        "", {{-0.5f, 1, -0.3f}, {0.5f, 1, -0.3f}, {0.5f, 1, 0.3f}, {-0.5f, 1, 0.3f}}, vec3(2.0f)};
    EXPECT_LT(glm::distance(polygon.normal(), rectangle.normal()), 1e-6f);
    expect_equal(polygon, rectangle, 5e-3f, 256);
    expect_equal(scene::MeshLight{"",
                                  {{{polygon.corners[0], polygon.corners[1], polygon.corners[2]}, {}},
                                   {{polygon.corners[0], polygon.corners[2], polygon.corners[3]}, {}}},
                                  vec3(2.0f)},
                 rectangle, 0.02f, 1024);
});

scene::Scene with_profile(scene::LightProfile profile) {
    scene::Scene scene = lambert_plane(2.0f * near_extent);
    scene.profiles.push_back(std::move(profile));
    return scene;
}

const Test isotropic("law.emitter.profile.an_even_one_is_a_point", [] {
    scene::PointLight light{"", {0.1f, 1, 0}, vec3(1.0f)};
    const auto point = lit_by(scene::PointLight{"", {0.1f, 1, 0}, vec3(70.0f)}, 1);
    light.profile = 0;
    const auto scene = with_profile({"even", {0.0f, pi}, {0.0f, 2.0f * pi}, {70, 70, 70, 70}});
    EXPECT_LT(max_relative_difference(lit_by(light, 1, scene), point, 1e-4f), 1e-5f);
});

// γ from the nadir, φ from +X to +Z, both linear: I = (γ in rad) (1 + φ/2π) from above.
const Test angles("law.emitter.profile.knows_its_angles", [] {
    std::vector<float> I;
    const std::vector<float> phi{0.0f, 1.0f, 4.0f, 2.0f * pi};
    const std::vector<float> gamma{0.0f, 0.3f, 0.5f * pi};
    for (const float p : phi)
        for (const float g : gamma) I.push_back(g * (1.0f + p / (2.0f * pi)));
    scene::PointLight light{"", {0, 1, 0}, vec3(2.0f)};
    light.profile = 0;
    const auto image = lit_by(light, 1, with_profile({"", gamma, phi, I}));
    for (int y = 0; y < coarse_size; ++y) {
        for (int x = 0; x < coarse_size; ++x) {
            const vec2 p = place_of(x, y, coarse_size, near_extent);
            if (y == coarse_size / 2) continue; // φ = 0, where the grid's ends meet
            const float g = std::atan(glm::length(p));
            const float turn = std::atan2(p.y, p.x) / (2.0f * pi);
            const float expected = 2.0f * g * (1.0f + (turn < 0.0f ? turn + 1.0f : turn));
            const float d2 = 1.0f + glm::dot(p, p);
            EXPECT_NEAR(image.at(x, y)[0], expected / (d2 * std::sqrt(d2)) / pi, 2e-4f) << x << ' ' << y;
        }
    }
});

/// A picture whose left half is white, the right black, as every emissive material reads it.
scene::Scene with_half_white_texture() {
    scene::Scene scene = lambert_plane(2.0f * near_extent);
    scene::TextureImage image{"half", 64, 64, std::vector<std::uint8_t>(64 * 64 * 4, 0)};
    auto& texels = std::get<std::vector<std::uint8_t>>(image.texels);
    for (std::size_t i = 0; i < texels.size(); ++i)
        if (i / 4 % 64 < 32 || i % 4 == 3) texels[i] = 255;
    scene.images.push_back(std::move(image));
    scene.textures.push_back({0, {}, scene::ColorSpace::srgb});
    scene.textures.back().sampler.wrap_u = scene.textures.back().sampler.wrap_v = scene::Wrap::clamp_to_edge;
    return scene;
}

const Test textured("law.emitter.map.half_a_texture_is_half_a_rectangle", [] {
    const scene::Scene scene = with_half_white_texture();
    scene::RectangleLight light{"", {0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, vec3(2.0f)};
    const scene::RectangleLight half{"", {-0.25f, 1, 0}, {0.25f, 0, 0}, {0, 0, 0.5f}, vec3(2.0f)};
    const auto expected = lit_by(half, 1024);
    light.map.texture = 0;
    EXPECT_LT(max_relative_difference(lit_by(light, 1024, scene), expected, 1e-4f), 0.02f);

    scene::MeshLight mesh{"", {}, vec3(2.0f)};
    const std::array<vec3, 4> c{{{-0.5f, 1, -0.5f}, {0.5f, 1, -0.5f}, {0.5f, 1, 0.5f}, {-0.5f, 1, 0.5f}}};
    const std::array<vec2, 4> uv{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
    mesh.triangles = {{{c[0], c[1], c[2]}, {uv[0], uv[1], uv[2]}},
                      {{c[0], c[2], c[3]}, {uv[0], uv[2], uv[3]}}};
    mesh.texture = 0;
    EXPECT_LT(max_relative_difference(lit_by(mesh, 2048, scene), expected, 1e-4f), 0.05f);
});

// From within, and from below its horizon, an emitter gives nothing.
const Test inside("law.emitter.sphere.nothing_from_within", [] {
    for (const scene::Light& light :
         {scene::Light(scene::SphereLight{"", {0, 0.1f, 0}, 3.0f, vec3(1.0f)}),
          scene::Light(scene::TubeLight{"", {0, 0.1f, 0}, {1, 0, 0}, 3.0f, vec3(1.0f)})}) {
        const auto image = lit_by(light, 4);
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) EXPECT_EQ(image.pixels[i], 0.0f);
    }
});

} // namespace
