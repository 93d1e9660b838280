#include "render/probe.hpp"

#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int probed_size = 16, samples = 32;

scene::Scene glossy_plane() {
    scene::Scene scene = lambert_plane(4.0f, vec3(0.5f, 0.6f, 0.7f));
    scene.materials[0].specular = 1.0f;
    scene.materials[0].roughness = 0.4f;
    scene.materials[0].emission = vec3(0.01f, 0.02f, 0.03f);
    return scene;
}

const std::vector<scene::Light> lights{
    scene::PointLight{"point", {0.2f, 1, 0}, vec3(1.0f, 2.0f, 3.0f)},
    scene::RectangleLight{"panel", {0, 1, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(2.0f)},
    scene::SphereLight{"ball", {-0.5f, 0.7f, 0.3f}, 0.2f, vec3(1.0f, 0.5f, 0.2f)},
    scene::DirectionalLight{"sun", {0, -1, 0}, vec3(0.5f), 0.01f}};

render::RenderOptions options() {
    render::RenderOptions o;
    o.width = o.height = probed_size;
    o.samples = samples;
    o.seed = 3;
    return o;
}

// probe prints the pixel that render writes: the pixel to the bit, its terms to the rounding of a sum of 32
// samples.
const Test sum("law.probe.terms_add_up_to_the_pixel", [] {
    context();
    const scene::Camera camera = camera_from_above(1.0f);
    const scene::Scene plane = glossy_plane();
    const auto image = picture(plane, lights, camera, probed_size, samples, 3);
    const render::GpuScene scene(plane, lights);
    for (const auto& [column, row] : {std::pair{8, 8}, {0, 15}, {12, 3}}) {
        const auto terms = render::probe(scene, camera, options(), column, row);
        ASSERT_TRUE(terms);
        vec3 total = terms->L_e;
        for (const render::LightTerms& light : terms->lights) total += light.L_r;
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(terms->L_o[c], image.at(column, row)[static_cast<std::size_t>(c)]);
            EXPECT_NEAR(total[c] / terms->L_o[c], 1.0f, 3e-6f);
        }
    }
});

// On a Lambert plane every term has a closed form.
const Test forms("law.probe.terms_of_a_lambert_plane", [] {
    context();
    const render::GpuScene scene(lambert_plane(4.0f, vec3(0.5f)), lights);
    render::RenderOptions one = options();
    one.width = one.height = 1; // its centre is the nadir
    const auto terms = render::probe(scene, camera_from_above(1e-4f), one, 0, 0);
    ASSERT_TRUE(terms);
    EXPECT_LT(glm::length(terms->x), 1e-5f);
    EXPECT_LT(glm::distance(terms->n, vec3(0, 1, 0)), 1e-6f);
    EXPECT_LT(glm::distance(terms->wo, vec3(0, 1, 0)), 1e-6f);
    for (const render::LightTerms& light : terms->lights) {
        EXPECT_NEAR(light.f_r.x, 0.5f / pi, 1e-4f);
        EXPECT_EQ(light.V, 1.0f);
    }
    const render::LightTerms& point = terms->lights[0];
    const float d2 = 1.04f;
    EXPECT_NEAR(point.cos_i, 1.0f / std::sqrt(d2), 1e-4f);
    EXPECT_NEAR(point.E.y, 2.0f / (d2 * std::sqrt(d2)), 1e-3f);
    EXPECT_EQ(point.solid_angle, 0.0f);
    EXPECT_NEAR(terms->lights[2].solid_angle, 2.0f * pi * (1.0f - std::sqrt(1.0f - 0.04f / 0.83f)), 1e-5f);
    EXPECT_NEAR(terms->lights[3].solid_angle, pi * 1e-4f, 1e-7f);
    EXPECT_NEAR(terms->lights[3].E.x, 0.5f, 1e-4f);
    EXPECT_LT(glm::distance(terms->lights[3].wi, vec3(0, 1, 0)), 1e-3f);
});

/// The plane with a normal map, a texture of roughness and a stretched lobe.
scene::Scene textured_plane() {
    scene::Scene scene = glossy_plane();
    scene::Material& m = scene.materials[0];
    m.anisotropy = 0.7f;
    scene::TextureImage image;
    image.name = "normals";
    image.width = image.height = 64;
    std::vector<std::uint8_t> texels;
    for (int i = 0; i < 64 * 64; ++i)
        for (const int c : {100 + i % 56, 110 + i / 64, 220, 255})
            texels.push_back(static_cast<std::uint8_t>(c));
    image.texels = std::move(texels);
    scene.images.push_back(std::move(image));
    scene.textures.emplace_back();
    m.normal_texture.texture = 0;
    m.metallic_roughness_texture.texture = 0;
    scene::Mesh& mesh = scene.meshes[0];
    mesh.texcoords[0].clear();
    for (const vec3 p : mesh.positions) mesh.texcoords[0].emplace_back(0.7f * p.x, 0.7f * p.z);
    mesh.tangents.assign(mesh.positions.size(), vec4(1.0f, 0.0f, 0.0f, 1.0f));
    return scene;
}

// f_r along a light is the probe's f_r of that light, from the very fragment: textures, normal map, layers.
const Test lobe("law.probe.lobe_is_the_f_r_of_the_table", [] {
    context();
    const std::vector<scene::Light> points{scene::PointLight{"a", {0.2f, 1, 0}, vec3(1.0f, 2.0f, 3.0f)},
                                           scene::SpotLight{"b",
                                                            {-0.5f, 0.7f, 0.3f},
                                                            glm::normalize(vec3(0.5f, -0.7f, -0.3f)),
                                                            vec3(2.0f),
                                                            99.0f,
                                                            0.0f,
                                                            1.5f},
                                           scene::DirectionalLight{"c", {0, -1, 0}, vec3(0.5f)}};
    const render::GpuScene scene(textured_plane(), points);
    render::RenderOptions one = options();
    one.samples = 1;
    for (const auto& [column, row] : {std::pair{8, 9}, {1, 4}}) {
        const auto terms = render::probe(scene, camera_from_above(1.0f), one, column, row);
        ASSERT_TRUE(terms);
        std::vector<vec3> wi(100, vec3(0, 1, 0));
        for (const render::LightTerms& light : terms->lights) wi.push_back(light.wi);
        const auto brdf = render::evaluate_brdf(scene, camera_from_above(1.0f), one, column, row, wi);
        ASSERT_TRUE(brdf);
        EXPECT_FALSE(brdf->is_mirror);
        for (std::size_t k = 0; k < points.size(); ++k)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(brdf->f_r[100 + k][c] / terms->lights[k].f_r[c], 1.0f, 1e-4f)
                    << column << ' ' << k;
    }
    EXPECT_FALSE(render::evaluate_brdf(scene, camera_from_above(9.0f), one, 0, 0, std::array{vec3(0, 1, 0)}));
});

} // namespace
