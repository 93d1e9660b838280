#include "render/renderer.hpp"

#include "core/error.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <cmath>
#include <cstring>

using namespace sr;
using namespace sr::testing;

namespace {

// Blended instances are drawn back to front of a point that does not depend on how a file tells their place.
const Test blended_center(
    "unit.render.renderer.transforms_worked_into_vertices_leave_the_order_of_blended_instances", [] {
        context();
        scene::Scene scene;
        scene::Material material = lambert();
        material.alpha_mode = scene::AlphaMode::blend;
        add_quad(scene, vec3(0.0f), {1, 0, 0}, {0, 1, 0}, material);
        scene.meshes[0].positions[0] = {-3, -4, 0}; // a kite: the middle of its box depends on its turn
        scene.instances[0].world_from_object = mat4(0.8f, 0.6f, 0.0f, 0.0f, -1.2f, 1.6f, 0.0f, 0.0f, 0.0f,
                                                    0.0f, 1.0f, 0.0f, 5.0f, 6.0f, 7.0f, 1.0f);
        const render::GpuScene placed(scene, {});
        for (vec3& p : scene.meshes[0].positions)
            p = vec3(scene.instances[0].world_from_object * vec4(p, 1.0f));
        scene.instances[0].world_from_object = mat4(1.0f);
        const render::GpuScene baked(scene, {});
        ASSERT_EQ(placed.blended_draws().size(), 1u);
        ASSERT_EQ(baked.blended_draws().size(), 1u);
        EXPECT_LT(glm::distance(placed.blended_draws()[0].center, baked.blended_draws()[0].center), 1e-5f);
    });

const std::vector<scene::Light> lamps{
    scene::PointLight{"", {0.5f, 1.0f, 0.2f}, vec3(2.0f)},
    scene::RectangleLight{"", {0.0f, 1.5f, 0.0f}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(10.0f)},
};

/// Adds a square above the plane at height y, with a material.
scene::Scene with_square(scene::Scene scene, scene::Material material, float y) {
    scene::Mesh square = scene.meshes.front();
    for (vec3& p : square.positions) p = vec3(0.5f * p.x, y, 0.5f * p.z);
    square.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(std::move(material));
    scene.meshes.push_back(std::move(square));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, mat4(1.0f), "square"});
    return scene;
}

scene::Material emissive(vec3 L_e) {
    scene::Material material;
    material.base_color = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    material.specular = 0.0f;
    material.metallic = 0.0f;
    material.emission = L_e;
    return material;
}

const Test determinism("unit.render.renderer.two_runs_are_bit_identical", [] {
    const auto plane = lambert_plane(4.0f);
    const auto a = picture(plane, lamps, camera_from_above(2.0f), 64, 8, 7);
    const auto b = picture(plane, lamps, camera_from_above(2.0f), 64, 8, 7);
    const auto other = picture(plane, lamps, camera_from_above(2.0f), 64, 8, 8);
    EXPECT_EQ(std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * sizeof(float)), 0);
    EXPECT_NE(std::memcmp(a.pixels.data(), other.pixels.data(), a.pixels.size() * sizeof(float)), 0);
});

// The mean of more samples is closer to the mean of very many.
const Test converges("unit.render.renderer.more_samples_are_closer", [] {
    const auto plane = lambert_plane(4.0f);
    const auto rms = [&](int samples, const image::Image& truth) {
        const auto image = picture(plane, lamps, camera_from_above(2.0f), 32, samples, 3);
        double sum = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4)
            sum += std::pow(image.pixels[i] - truth.pixels[i], 2.0);
        return std::sqrt(sum / 1024.0);
    };
    const auto truth = picture(plane, lamps, camera_from_above(2.0f), 32, 4096, 4);
    const double at_4 = rms(4, truth), at_64 = rms(64, truth);
    EXPECT_LT(at_64, at_4 / 8.0) << "sixteen times the samples, at least N^-0.75";
});

const Test emission("unit.render.renderer.emission_is_radiance", [] {
    const auto scene = with_square(lambert_plane(2.0f), emissive(vec3(5.0f, 1e6f, 0.25f)), 0.5f);
    const auto image = picture(scene, {}, camera_from_above(2.0f), 16);
    EXPECT_EQ(image.at(8, 8)[0], 5.0f);
    EXPECT_EQ(image.at(8, 8)[1], 1e6f) << "nothing before the film clamps";
    EXPECT_EQ(image.at(8, 8)[2], 0.25f);
    EXPECT_EQ(image.at(0, 0)[0], 0.0f) << "the plane is dark: nothing lights it";
});

const Test blend("unit.render.renderer.blend_covers_by_alpha", [] {
    scene::Material glass = emissive(vec3(8.0f));
    glass.base_color.w = 0.25f;
    glass.alpha_mode = scene::AlphaMode::blend;
    auto scene = with_square(lambert_plane(4.0f), emissive(vec3(4.0f)), 0.2f);
    scene = with_square(std::move(scene), glass, 0.5f);
    const auto image = picture(scene, {}, camera_from_above(2.0f), 16);
    EXPECT_NEAR(image.at(8, 8)[0], 0.25f * 8.0f + 0.75f * 4.0f, 1e-5f);
    EXPECT_NEAR(image.at(8, 8)[3], 1.0f, 1e-6f);
});

// Two panes on top of each other do not commute: the far one is drawn first, however the file lists them.
const Test order("unit.render.renderer.blend_goes_from_far_to_near", [] {
    const auto pane = [](float L) {
        scene::Material m = emissive(vec3(L));
        m.base_color.w = 0.5f;
        m.alpha_mode = scene::AlphaMode::blend;
        return m;
    };
    const auto near_first = with_square(with_square(lambert_plane(4.0f), pane(8.0f), 0.9f), pane(2.0f), 0.3f);
    const auto far_first = with_square(with_square(lambert_plane(4.0f), pane(2.0f), 0.3f), pane(8.0f), 0.9f);
    for (const auto& scene : {near_first, far_first})
        EXPECT_NEAR(picture(scene, {}, camera_from_above(2.0f), 16).at(8, 8)[0],
                    0.5f * 8.0f + 0.5f * 0.5f * 2.0f, 1e-5f);
});

const Test mask("unit.render.renderer.mask_cuts_below_the_cutoff", [] {
    for (const float alpha : {0.4f, 0.6f}) {
        scene::Material leaf = emissive(vec3(8.0f));
        leaf.base_color.w = alpha;
        leaf.alpha_mode = scene::AlphaMode::mask;
        const auto scene = with_square(lambert_plane(4.0f), leaf, 0.5f);
        EXPECT_EQ(picture(scene, {}, camera_from_above(2.0f), 16).at(8, 8)[0], alpha < 0.5f ? 0.0f : 8.0f);
    }
});

const Test culling("unit.render.renderer.backs_are_seen_only_if_double_sided", [] {
    for (const bool is_double_sided : {false, true}) {
        for (const bool is_mirrored : {false, true}) {
            scene::Material sheet = emissive(vec3(8.0f));
            sheet.is_double_sided = is_double_sided;
            auto scene = with_square(lambert_plane(4.0f), sheet, 0.5f);
            // Turned over by a rotation the square shows its back; mirrored it still shows its front.
            mat4 m(1.0f);
            if (is_mirrored)
                m[0][0] = -1.0f;
            else
                m = mat4(vec4(1, 0, 0, 0), vec4(0, -1, 0, 0), vec4(0, 0, -1, 0), vec4(0, 1, 0, 1));
            scene.instances.back().world_from_object = m;
            const bool is_seen = is_mirrored || is_double_sided;
            EXPECT_EQ(picture(scene, {}, camera_from_above(2.0f), 16).at(8, 8)[0], is_seen ? 8.0f : 0.0f);
        }
    }
});

const Test background("unit.render.renderer.background_has_no_coverage", [] {
    context();
    const render::GpuScene scene(scene::Scene{}, {});
    render::RenderOptions options;
    options.width = 7;
    options.height = 5;
    options.background = vec3(1.0f, 2.0f, 3.0f);
    options.samples = 3;
    render::Renderer renderer(scene, camera_from_above(1.0f), options);
    for (int i = 0; i < 3; ++i) renderer.add_sample();
    const auto film = renderer.read_film();
    EXPECT_FLOAT_EQ(film.at(6, 4)[2], 3.0f);
    EXPECT_EQ(film.at(6, 4)[3], 0.0f);
});

const Test overlay("unit.render.renderer.an_overlay_replaces_a_term", [] {
    context();
    const auto plane = lambert_plane(4.0f);
    const std::vector<scene::Light> lights{scene::PointLight{"", {0.0f, 1.0f, 0.0f}, vec3(1.0f)}};
    const render::GpuScene scene(plane, lights);
    render::RenderOptions options;
    options.width = options.height = 65;
    options.samples = 1;
    options.shader_path = {
        glsl::Root::memory(
            "mine", {{"brdf/f_r.glsl", "#include \"surface/surface.glsl\"\n"
                                       "vec3 f_r(Surface x, vec3 wi, vec3 wo) { return vec3(2.0); }\n"}}),
        glsl::embedded()};
    render::Renderer renderer(scene, camera_from_above(2.0f), options);
    renderer.add_sample();
    EXPECT_NEAR(renderer.read_film().at(32, 32)[0], 2.0f, 1e-4f);
});

const Test broken("unit.render.renderer.a_broken_shader_names_its_line", [] {
    context();
    const auto plane = lambert_plane(4.0f);
    const render::GpuScene scene(plane, {});
    render::RenderOptions options;
    options.shader_path = {
        glsl::Root::memory("mine",
                           {{"brdf/f_r.glsl", "#include \"surface/surface.glsl\"\n\n"
                                              "vec3 f_r(Surface x, vec3 wi, vec3 wo) { return albedo; }\n"}}),
        glsl::embedded()};
    render::Renderer renderer(scene, camera_from_above(2.0f), options);
    try {
        renderer.compile();
        FAIL() << "it compiled";
    } catch (const gl::ShaderError& error) {
        EXPECT_EQ(std::string(error.what()).find("mine/brdf/f_r.glsl:3"), 0u) << error.what();
        EXPECT_NE(std::string(error.what()).find("albedo"), std::string::npos) << error.what();
    }
});

} // namespace
