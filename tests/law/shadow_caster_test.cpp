#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include "scene/prepare.hpp"

#include <algorithm>
#include <cmath>
#include <random>

using namespace sr;
using namespace sr::testing;
using render::Visibility;

namespace {

constexpr std::array every_provider{Visibility::ray_on_cpu, Visibility::ray_in_glsl, Visibility::map};
constexpr int size = 64;
constexpr float extent = 2.0f;

/// The sun from the left, so that a sheet's shadow falls beside it: what stands at height h moves to x + h.
const std::vector<scene::Light> sun{
    scene::DirectionalLight{"", glm::normalize(vec3(1.0f, -1.0f, 0.0f)), vec3(1.0f)}};

scene::Material of_alpha(scene::AlphaMode mode, float alpha) {
    scene::Material material = lambert();
    material.alpha_mode = mode;
    material.base_color.w = alpha;
    return material;
}

/// Adds a texture of one row of alphas to the scene, and the material that is cut by it.
scene::Material fence(scene::Scene& scene, std::vector<std::uint8_t> alphas, scene::Wrap wrap) {
    scene::TextureImage image{"alphas", static_cast<int>(alphas.size()), 1, {}};
    auto& texels = image.texels.emplace<std::vector<std::uint8_t>>();
    for (const std::uint8_t alpha : alphas) texels.insert(texels.end(), {255, 255, 255, alpha});
    scene.images.push_back(image);
    scene::Texture texture;
    texture.sampler.wrap_u = wrap;
    scene.textures.push_back(texture);
    scene::Material material = of_alpha(scene::AlphaMode::mask, 1.0f);
    material.base_color_texture.texture = 0;
    return material;
}

/// V at place (x, 0): what the sun gives there, to what it gives without anything.
float V_at(const image::Image& image, float x) {
    const int column = static_cast<int>((x / extent + 1.0f) * 0.5f * size);
    return image.at(column, size / 2)[0] * pi * std::sqrt(2.0f);
}

const Test mask("law.shadow.a_mask_lets_through_what_it_cuts_away", [] {
    // Twice the texture over the sheet: cut | kept | cut | kept, each 0.25 wide; mirrored: cut | kept | kept
    // | cut.
    struct Case {
        scene::Wrap wrap;
        std::array<float, 4> V;
    };
    for (const Case& c :
         {Case{scene::Wrap::repeat, {1, 0, 1, 0}}, Case{scene::Wrap::mirrored_repeat, {1, 0, 0, 1}},
          Case{scene::Wrap::clamp_to_edge, {1, 0, 0, 0}}}) {
        auto scene = lambert_plane(4.0f);
        auto material = fence(scene, {0, 0, 0, 0, 255, 255, 255, 255}, c.wrap);
        material.base_color_texture.uv_transform[0][0] = 2.0f;
        add_quad(scene, {-0.5f, 1.0f, 0.0f}, {0.5f, 0, 0}, {0, 0, -1.0f}, material);
        for (const Visibility visibility : every_provider) {
            const auto image = picture(scene, sun, camera_from_above(extent), size, 1, 0, visibility);
            for (std::size_t i = 0; i < 4; ++i)
                EXPECT_NEAR(V_at(image, 0.125f + 0.25f * static_cast<float>(i)), c.V[i], 1e-4f) << i;
            EXPECT_NEAR(V_at(image, 1.2f), 1.0f, 1e-4f) << "beside the sheet";
        }
    }
});

const Test blend("law.shadow.transparent_sheets_multiply", [] {
    auto scene = lambert_plane(4.0f);
    add_quad(scene, {-0.5f, 1.0f, 0.0f}, {0.5f, 0, 0}, {0, 0, 1.0f},
             of_alpha(scene::AlphaMode::blend, 0.25f));
    add_quad(scene, {-0.8f, 1.1f, 0.0f}, {0.3f, 0, 0}, {0, 0, 1.0f}, of_alpha(scene::AlphaMode::blend, 0.5f));
    for (const Visibility visibility : every_provider) {
        const bool by_chance =
            visibility == Visibility::map; // a sheet is there in as many samples as it is dense
        const float slack = by_chance ? 0.02f : 1e-5f;
        const auto image =
            picture(scene, sun, camera_from_above(extent), size, by_chance ? 256 : 1, 0, visibility);
        EXPECT_NEAR(V_at(image, 0.3f), 0.75f * 0.5f, 3.0f * slack); // two chances: σ is 0.03
        EXPECT_NEAR(V_at(image, 0.8f), 0.75f, slack);
        EXPECT_NEAR(V_at(image, 1.2f), 1.0f, 1e-5f);
    }
});

// Shadows fall on transparent surfaces, too.
const Test receiver("law.shadow.a_transparent_sheet_receives_shadows", [] {
    auto scene = lambert_plane(4.0f, vec3(0.0f));
    add_quad(scene, {0.0f, 0.5f, 0.0f}, {2.0f, 0, 0}, {0, 0, -2.0f}, of_alpha(scene::AlphaMode::blend, 0.5f));
    add_quad(scene, {-0.5f, 1.5f, 0.0f}, {0.5f, 0, 0}, {0, 0, 1.0f}, lambert()); // seen from its culled back
    for (const Visibility visibility : every_provider) {
        const auto image = picture(scene, sun, camera_from_above(extent), size, 1, 0, visibility);
        EXPECT_EQ(V_at(image, 0.5f), 0.0f);
        EXPECT_NEAR(V_at(image, 1.5f), 0.5f, 1e-4f) << "half covered, lit";
    }
});

/// The plane under an emissive box, whose six faces are six rectangles of one instance.
scene::RenderScene under_a_glowing_box(bool is_two_sided) {
    auto scene = lambert_plane(4.0f);
    scene::Material glowing = lambert(vec3(0.0f));
    glowing.emission = vec3(5.0f);
    glowing.is_double_sided = is_two_sided;
    add_box(scene, {0.0f, 1.0f, 0.0f}, mat3(0.4f), 1, glowing);
    return scene::prepare_scene(std::move(scene), "", {});
}

// From below only the lowest face of the box is seen, though a two-sided one shines down from the topmost as
// well.
const Test group("law.shadow.an_emitters_faces_hide_each_other", [] {
    const std::vector<scene::Light> lowest{
        scene::RectangleLight{"", {0.0f, 0.6f, 0.0f}, {0.4f, 0, 0}, {0, 0, 0.4f}, vec3(5.0f)}};
    const auto camera = camera_from_above(0.3f);
    const auto mean_E = [&](const scene::Scene& scene, std::span<const scene::Light> lights,
                            Visibility visibility) {
        auto from_below_the_box = camera;
        std::get<scene::Orthographic>(from_below_the_box.projection).znear = 9.7f; // cuts the box away
        const auto image = picture(scene, lights, from_below_the_box, 32, 64, 0, visibility);
        double sum = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) sum += image.pixels[i];
        return sum;
    };
    const double expected = mean_E(lambert_plane(4.0f), lowest, Visibility::none);
    for (const bool is_two_sided : {false, true}) {
        const auto stage = under_a_glowing_box(is_two_sided);
        ASSERT_EQ(stage.lights.size(), 6u);
        for (const Visibility visibility : every_provider)
            EXPECT_NEAR(mean_E(stage.scene, stage.lights, visibility) / expected, 1.0, 2e-3);
    }
});

// A panel does not stand in its own light, but in that of a lamp above it.
const Test emitter("law.shadow.an_emitter_shadows_others_only", [] {
    auto scene = lambert_plane(4.0f);
    scene.lights.emplace_back(
        scene::RectangleLight{"panel", {0.0f, 0.5f, 0.0f}, {0.2f, 0, 0}, {0, 0, 0.2f}, vec3(5.0f)});
    scene.lights.emplace_back(scene::PointLight{"lamp", {0.0f, 1.0f, 0.0f}, vec3(1.0f)});
    const auto stage = scene::prepare_scene(scene, "", {});
    const std::span<const scene::Light> all(stage.lights);
    const auto camera = camera_from_above(extent);
    for (const Visibility visibility : every_provider) {
        const auto panel = [&](Visibility how) {
            std::vector<scene::Light> lights(all.begin(), all.end());
            std::get<scene::PointLight>(lights[1]).I = vec3(0.0f);
            return picture(stage.scene, lights, camera, size, 4, 0, how);
        };
        EXPECT_LT(max_relative_difference(panel(visibility), panel(Visibility::none), 1e-3f), 2e-4f);
        std::vector<scene::Light> lights(all.begin(), all.end());
        std::get<scene::RectangleLight>(lights[0]).L = vec3(0.0f);
        const auto lamp = picture(stage.scene, lights, camera, size, 1, 0, visibility);
        // The panel's shadow is twice as wide as the panel.
        for (const auto& [x, is_lit] : {std::pair(0.33f, false), std::pair(0.45f, true)})
            EXPECT_EQ(lamp.at(static_cast<int>((x / extent + 1.0f) * 0.5f * size), size / 2)[0] > 0.0f,
                      is_lit)
                << x;
    }
});

/// Triangles anywhere within the box ±1.5 above the plane, some cut, some transparent.
scene::Scene heap(int triangles) {
    auto scene = lambert_plane(4.0f);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> within(-1.0f, 1.0f);
    const auto point = [&](float reach) {
        return reach * vec3(within(random), within(random), within(random));
    };
    const auto cut = fence(scene, {0, 255, 90, 200}, scene::Wrap::repeat);
    for (int i = 0; i < triangles; ++i) {
        const auto material = i % 4 == 0   ? cut
                              : i % 4 == 1 ? of_alpha(scene::AlphaMode::blend, 0.3f)
                                           : lambert();
        add_quad(scene, point(1.5f) + vec3(0.0f, 1.7f, 0.0f), point(0.4f), point(0.4f), material);
        scene.materials.back().is_double_sided = true;
    }
    return scene;
}

// The shader's walk and Embree see the same; a ray through an edge may be decided otherwise by each. (What
// another program rounds otherwise stays far below 1e-3, an answer that differs far above.)
const Test equal("law.shadow.both_providers_agree", [] {
    const auto scene = heap(200);
    const std::vector<scene::Light> lights{
        scene::PointLight{"", {-1.0f, 4.0f, 0.5f}, vec3(30.0f)}, sun[0],
        scene::RectangleLight{"", {0.5f, 5.0f, 0.0f}, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(100.0f)}};
    const auto cpu = picture(scene, lights, camera_from_above(extent), 128, 2, 0, Visibility::ray_on_cpu);
    const auto glsl = picture(scene, lights, camera_from_above(extent), 128, 2, 0, Visibility::ray_in_glsl);
    int different = 0;
    for (std::size_t i = 0; i < cpu.pixels.size(); i += 4)
        different +=
            std::abs(cpu.pixels[i] - glsl.pixels[i]) > 1e-3f * std::max(cpu.pixels[i], glsl.pixels[i]);
    EXPECT_LE(different, 16) << "of 16384 pixels with 6 rays each";
    ::testing::Test::RecordProperty("different_pixels", different);
});

const Test degenerate("law.shadow.degenerate_triangles_do_no_harm", [] {
    auto clean = lambert_plane(4.0f);
    add_quad(clean, {-0.5f, 1.0f, 0.0f}, {0.5f, 0, 0}, {0, 0, 1.0f}, lambert());
    auto broken = clean;
    scene::Mesh& mesh = broken.meshes[1];
    const float nan = std::nanf("");
    mesh.positions.insert(mesh.positions.end(), {vec3(nan), vec3(INFINITY), vec3(0.3f, nan, 0.0f)});
    mesh.normals.resize(7, vec3(0.0f, 1.0f, 0.0f));
    mesh.texcoords[0].resize(7);
    for (int i = 0; i < 40; ++i) // the same again, points, lines, and corners that are no numbers
        mesh.indices.insert(mesh.indices.end(),
                            {0, 1, 2, 1, 1, 1, 0, 1, 1, 0, 1, 4, 5, 2, 3, 6, 0, 1, 4, 5, 6});
    for (const Visibility visibility : every_provider) {
        const auto expected = picture(clean, sun, camera_from_above(extent), size, 1, 0, visibility);
        const auto image = picture(broken, sun, camera_from_above(extent), size, 1, 0, visibility);
        EXPECT_LT(max_relative_difference(image, expected, 1e-3f), 1e-6f);
    }
});

// A user's shader may ask for a ray that leads nowhere: its pixels say so, and the program lives.
const Test broken("law.shadow.a_broken_ray_is_not_a_number", [] {
    context();
    const auto scene = lambert_plane(4.0f);
    const std::vector<scene::Light> lights{scene::RectangleLight{
        "", vec3(0, 1, 0), vec3(0.1f, 0, 0), vec3(0, 0, 0.1f), vec3(1.0f), false, false, {}}};
    const render::GpuScene gpu_scene(scene, lights, Visibility::ray_on_cpu);
    render::RenderOptions options;
    options.width = options.height = 8;
    options.shader_path.insert(
        options.shader_path.begin(),
        glsl::Root::memory("user", {{"integrator/reflected.glsl",
                                     "#include \"integrator/rays.glsl\"\n"
                                     "#include \"visibility/visibility.glsl\"\n"
                                     "vec3 reflected(Surface x, vec3 wo) {\n"
                                     "    vec3 wi = vec3(intBitsToFloat(0x7fc00000));\n"
                                     "    return vec3(visibility(x, wi, 1.0, 0, towards_light));\n"
                                     "}\n"}}));
    render::Renderer renderer(gpu_scene, camera_from_above(2.0f), options);
    renderer.add_sample();
    EXPECT_TRUE(std::isnan(renderer.read_film().at(4, 4)[0]));
});

} // namespace
