// Glass (KHR_materials_transmission, _volume, _ior) and sheets that transmit diffusely.
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

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
const vec3 amber(0.9f, 0.5f, 0.2f);

scene::Material glass(vec3 color = amber, float ior = 1.5f) {
    scene::Material material;
    material.base_color = vec4(color, 1.0f);
    material.metallic = material.roughness = 0.0f;
    material.transmission = 1.0f;
    material.ior = ior;
    return material;
}

/// 1 - F, by Schlick.
float passed(float cos_w, float ior = 1.5f) {
    const float F0 = std::pow((ior - 1.0f) / (ior + 1.0f), 2.0f);
    return 1.0f - (F0 + (1.0f - F0) * std::pow(1.0f - cos_w, 5.0f));
}

/// The sun from the left, 45° high: what stands at height h casts its shadow at x + h.
const scene::Light slanting =
    scene::DirectionalLight{"", glm::normalize(vec3(1.0f, -1.0f, 0.0f)), vec3(1.0f)};

/// The plane under a pane at height 1 above x < 0, which the camera sees from its culled back.
scene::Scene under_a_pane(const scene::Material& material) {
    auto scene = lambert_plane(4.0f);
    add_quad(scene, {-1.0f, 1.0f, 0.0f}, {1.0f, 0, 0}, {0, 0, 2.0f}, material);
    return scene;
}

/// V at the place (x, 0) of the plane under the slanting sun.
vec3 V_at(const image::Image& image, float x) {
    const auto texel = image.at(static_cast<int>((x / extent + 1.0f) * 0.5f * size), size / 2);
    return vec3(texel[0], texel[1], texel[2]) * pi * std::sqrt(2.0f);
}

vec3 V_under(const scene::Scene& scene, Visibility visibility) {
    return V_at(picture(scene, std::span(&slanting, 1), camera_from_above(extent), size, 1, 0, visibility),
                -0.5f);
}

void expect_near(vec3 value, vec3 expected, float tolerance, std::string_view what = "") {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(value[c], expected[c], tolerance) << what << ", channel " << c;
}

// V = ρ (1 - F): the light on the floor has the colour of the pane, from either side of it.
const Test tint("law.glass.a_pane_tints_the_light", [] {
    for (const Visibility visibility : every_provider) {
        const vec3 expected = amber * passed(std::sqrt(0.5f));
        const auto image = picture(under_a_pane(glass()), std::span(&slanting, 1), camera_from_above(extent),
                                   size, 1, 0, visibility);
        expect_near(V_at(image, -0.5f), expected, 1e-5f);
        expect_near(V_at(image, 1.5f), vec3(1.0f), 1e-5f, "beside it");
        auto turned = under_a_pane(glass());
        turned.instances[1].world_from_object[1].y = -1.0f; // upside down, by mirroring at y = 1
        turned.instances[1].world_from_object[3].y = 2.0f;
        turned.materials[1].is_double_sided = false;
        turned.meshes[1].indices = {0, 2, 1, 0, 3, 2}; // so that its back stays up
        expect_near(V_under(turned, visibility), expected, 1e-5f);
        expect_near(V_under(under_a_pane(glass(amber, 1.0f)), visibility),
                    amber * passed(std::sqrt(0.5f), 1.0f), 1e-5f);
    }
});

// Panes multiply, in any order, and what stands behind one is not lit through it.
const Test stack("law.glass.panes_multiply", [] {
    auto scene = lambert_plane(4.0f);
    const vec3 blue(0.2f, 0.4f, 0.9f);
    add_quad(scene, {-1.0f, 1.0f, 0.0f}, {1.0f, 0, 0}, {0, 0, 2.0f}, glass());
    add_quad(scene, {-1.2f, 1.2f, 0.0f}, {1.0f, 0, 0}, {0, 0, 2.0f}, glass(blue));
    auto blocked = scene;
    add_quad(blocked, {-1.1f, 1.1f, 0.0f}, {1.0f, 0, 0}, {0, 0, 2.0f}, lambert());
    const vec3 expected = amber * blue * passed(std::sqrt(0.5f)) * passed(std::sqrt(0.5f));
    for (const Visibility visibility : every_provider) {
        expect_near(V_under(scene, visibility), expected, 1e-5f);
        expect_near(V_under(blocked, visibility), vec3(0.0f), 0.0f);
    }
});

// Beer and Lambert: exp(-σ d) is attenuationColor^(d / attenuationDistance), d in world space.
const Test beer("law.glass.volume_attenuates_as_beer_and_lambert_say", [] {
    auto material = glass(vec3(1.0f));
    material.thickness = 0.5f;
    material.attenuation_distance = 0.25f;
    material.attenuation_color = vec3(0.9f, 0.5f, 0.2f);
    const vec3 twice = material.attenuation_color * material.attenuation_color;
    auto scaled = under_a_pane(material);
    scaled.instances[1].world_from_object = mat4(mat3(2.0f));
    scaled.instances[1].world_from_object[3] = vec4(1.0f, -1.0f, 0.0f, 1.0f);
    for (const Visibility visibility : every_provider) {
        expect_near(V_under(under_a_pane(material), visibility), twice * passed(std::sqrt(0.5f)), 1e-5f);
        expect_near(V_under(scaled, visibility), twice * twice * passed(std::sqrt(0.5f)), 1e-5f,
                    "scaled by 2");
    }
});

// A closed body has two walls, and its thickness once.
const Test body("law.glass.a_closed_body_attenuates_once", [] {
    auto material = glass();
    material.thickness = 0.5f;
    material.attenuation_distance = 0.5f;
    material.attenuation_color = vec3(0.9f, 0.5f, 0.2f);
    const scene::Light above = scene::DirectionalLight{"", {0.0f, -1.0f, 0.0f}, vec3(1.0f)};
    for (const float side : {1.0f, -1.0f}) { // mirrored, too
        auto scene = lambert_plane(4.0f);
        add_box(scene, {0.0f, 1.0f, 0.0f}, mat3(0.5f), 2, material);
        scene.instances[1].world_from_object[0].x = side;
        auto camera = camera_from_above(0.4f);
        std::get<scene::Orthographic>(camera.projection).znear = 9.8f; // cuts the box away
        for (const Visibility visibility : every_provider) {
            const auto image = picture(scene, std::span(&above, 1), camera, 8, 1, 0, visibility);
            const auto texel = image.at(3, 3);
            const vec3 walls = amber * passed(1.0f) * amber * passed(1.0f);
            expect_near(vec3(texel[0], texel[1], texel[2]) * pi, walls * material.attenuation_color, 1e-5f);
        }
    }
});

/// Renders the view of the camera above through the pane of a plane that shines with L = 2 on all sides.
vec4 seen_through(const scene::Material& material, float tilt = 0.0f, bool has_plane = true) {
    scene::Scene scene;
    scene::Material glow = lambert(vec3(1.0f));
    glow.base_color = vec4(2.0f, 2.0f, 2.0f, 1.0f);
    glow.is_unlit = true;
    if (has_plane) add_quad(scene, {0, -3, 0}, {4.0f, 0, 0}, {0, 0, -4.0f}, glow);
    add_quad(scene, {0, 0, 0}, vec3(std::cos(tilt), std::sin(tilt), 0.0f), {0, 0, -1.0f}, material);
    const image::Image image = picture(scene, {}, camera_from_above(0.2f), 8);
    const auto texel = image.at(3, 3);
    return {texel[0], texel[1], texel[2], texel[3]};
}

const Test seen("law.glass.what_is_behind_is_seen_tinted", [] {
    for (const float tilt : {0.0f, 0.5f, 1.2f}) {
        const vec4 film = seen_through(glass(), tilt);
        expect_near(vec3(film), 2.0f * amber * passed(std::cos(tilt)), 1e-5f);
        EXPECT_NEAR(film.w, 1.0f, 1e-6f) << "the plane covers all";
    }
    const vec4 alone = seen_through(glass(), 0.0f, false);
    expect_near(vec3(alone), vec3(0.0f), 0.0f);
    EXPECT_NEAR(alone.w, 1.0f - passed(1.0f) * (amber.x + amber.y + amber.z) / 3.0f, 1e-6f);
});

// alphaMode says how much of the surface is there: where it is not, all light passes.
const Test alpha("law.glass.alpha_says_how_much_glass_is_there", [] {
    for (const auto mode : {scene::AlphaMode::mask, scene::AlphaMode::blend}) {
        for (const float a : {0.25f, 0.75f}) {
            auto material = glass();
            material.alpha_mode = mode;
            material.base_color.w = a;
            const float there = mode == scene::AlphaMode::blend ? a : a < 0.5f ? 0.0f : 1.0f;
            const auto expected = [&](float cos_w) {
                return glm::mix(vec3(1.0f), amber * passed(cos_w), there);
            };
            for (const Visibility visibility : every_provider)
                expect_near(V_under(under_a_pane(material), visibility), expected(std::sqrt(0.5f)), 1e-5f);
            expect_near(vec3(seen_through(material)), 2.0f * expected(1.0f), 1e-5f);
        }
    }
});

/// Adds a picture of two texels, the left half of a pane and the right one.
int two_texels(scene::Scene& scene, std::array<std::uint8_t, 8> texels, scene::ColorSpace color_space) {
    scene.images.push_back({"halves", 2, 1, std::vector<std::uint8_t>(texels.begin(), texels.end())});
    scene::Texture texture;
    texture.image = static_cast<int>(scene.images.size()) - 1;
    texture.color_space = color_space;
    texture.sampler.wrap_u = texture.sampler.wrap_v = scene::Wrap::clamp_to_edge;
    texture.sampler.magnification = texture.sampler.minification = scene::Filter::nearest;
    texture.sampler.mipmap = scene::Mipmap::none;
    scene.textures.push_back(texture);
    return static_cast<int>(scene.textures.size()) - 1;
}

// Each of the four textures has its say, in V as in what is seen. (V is bilinear: asked in the middle of a
// texel.)
const Test textures("law.glass.textures_are_read_by_v_and_by_the_eye", [] {
    using Texels = std::array<std::uint8_t, 8>;
    struct Case {
        scene::TextureSlot scene::Material::*slot;
        Texels texels;
        scene::ColorSpace color_space;
        std::array<vec3, 2> factor; // of T on the left and on the right
    };
    const float half = 0.21586f; // sRGB code 128
    const vec3 dense(std::exp(-1.0f)), thin(std::exp(-51.0f / 255.0f));
    for (const Case& c : {
             Case{&scene::Material::base_color_texture,
                  Texels{255, 128, 0, 255, 128, 255, 255, 255},
                  scene::ColorSpace::srgb,
                  {vec3(1, half, 0) * dense, vec3(half, 1, 1) * dense}},
             Case{&scene::Material::transmission_texture,
                  Texels{51, 255, 255, 255, 255, 0, 0, 0},
                  scene::ColorSpace::linear,
                  {0.2f * dense, dense}},
             Case{&scene::Material::thickness_texture,
                  Texels{0, 51, 255, 0, 255, 0, 255, 0},
                  scene::ColorSpace::linear,
                  {thin, vec3(1.0f)}},
             Case{&scene::Material::metallic_roughness_texture,
                  Texels{0, 0, 51, 0, 0, 0, 255, 0},
                  scene::ColorSpace::linear,
                  {0.8f * dense, vec3(0.0f)}},
         }) {
        auto scene = lambert_plane(4.0f);
        auto material = glass(vec3(1.0f));
        material.metallic = c.slot == &scene::Material::metallic_roughness_texture ? 1.0f : 0.0f;
        material.thickness = 1.0f;
        material.attenuation_distance = 1.0f;
        material.attenuation_color = vec3(std::exp(-1.0f));
        (material.*c.slot).texture = two_texels(scene, c.texels, c.color_space);
        add_quad(scene, {-1.0f, 1.0f, 0.0f}, {1.0f, 0, 0}, {0, 0, 2.0f}, material);
        for (const Visibility visibility : every_provider) {
            const auto image =
                picture(scene, std::span(&slanting, 1), camera_from_above(extent), size, 1, 0, visibility);
            for (const int side :
                 {0, 1}) // the middles of the texels are at x = -1.5 and -0.5, their light at +1
                expect_near(V_at(image, side == 0 ? -0.5f : 0.53f),
                            c.factor[static_cast<std::size_t>(side)] * passed(std::sqrt(0.5f)), 4e-2f);
        }
    }
});

// Opaque parts of a texture hide what is behind, in any order of the triangles.
const Test part("law.glass.opaque_parts_hide_each_other", [] {
    auto scene = lambert_plane(4.0f);
    auto material = glass(vec3(1.0f));
    material.specular = 0.0f;
    material.transmission_texture.texture =
        two_texels(scene, {0, 0, 0, 0, 255, 0, 0, 0}, scene::ColorSpace::linear);
    add_quad(scene, {0.0f, 1.0f, 0.0f}, {1.0f, 0, 0}, {0, 0, -1.0f}, material);
    scene::Mesh& mesh = scene.meshes[1]; // its first triangles are above, red; those after are below, green
    for (int i = 0; i < 4; ++i) {
        mesh.positions.push_back(mesh.positions[static_cast<std::size_t>(i)] - vec3(0.0f, 0.5f, 0.0f));
        mesh.normals.push_back(mesh.normals[0]);
        mesh.texcoords[0].push_back(mesh.texcoords[0][static_cast<std::size_t>(i)]);
    }
    mesh.indices.insert(mesh.indices.end(), {4, 5, 6, 4, 6, 7});
    for (int i = 0; i < 8; ++i) mesh.colors.push_back(i < 4 ? vec4(1, 0, 0, 1) : vec4(0, 1, 0, 1));
    const scene::Light above = scene::DirectionalLight{"", {0.0f, -1.0f, 0.0f}, vec3(pi)};
    for (const Visibility visibility : every_provider) {
        const auto image =
            picture(scene, std::span(&above, 1), camera_from_above(extent), size, 1, 0, visibility);
        const auto opaque = image.at(size / 2 - 8, size / 2), clear = image.at(size / 2 + 8, size / 2);
        expect_near({opaque[0], opaque[1], opaque[2]}, {1.0f, 0.0f, 0.0f}, 1e-5f);
        expect_near({clear[0], clear[1], clear[2]}, vec3(0.0f), 1e-5f, "red times green");
    }
});

/// Panes anywhere above the plane, of glass with every property, some cut, some in part metal.
scene::Scene heap() {
    auto scene = lambert_plane(4.0f);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> within(-1.0f, 1.0f);
    const auto point = [&](float reach) {
        return reach * vec3(within(random), within(random), within(random));
    };
    const int map = two_texels(scene, {255, 128, 40, 30, 128, 200, 90, 255}, scene::ColorSpace::srgb);
    const int data = two_texels(scene, {255, 128, 40, 30, 128, 200, 90, 255}, scene::ColorSpace::linear);
    for (int i = 0; i < 120; ++i) {
        auto material = glass(vec3(0.5f) + 0.5f * glm::abs(point(1.0f)), 1.0f + std::abs(within(random)));
        material.thickness = i % 3 == 0 ? 0.5f : 0.0f;
        material.attenuation_distance = 0.7f;
        material.attenuation_color = glm::abs(point(1.0f));
        material.clearcoat = i % 5 == 0 ? 1.0f : 0.0f;
        material.alpha_mode = i % 4 == 0   ? scene::AlphaMode::blend
                              : i % 4 == 1 ? scene::AlphaMode::mask
                                           : scene::AlphaMode::opaque;
        if (i % 2 == 0) material.base_color_texture.texture = map;
        if (i % 7 == 0) material.transmission_texture.texture = material.thickness_texture.texture = data;
        if (i % 6 == 0) material.metallic_roughness_texture.texture = data, material.metallic = 1.0f;
        if (i % 10 == 0) material = lambert();
        add_quad(scene, point(1.5f) + vec3(0.0f, 1.7f, 0.0f), point(0.5f), point(0.5f), material);
    }
    return scene;
}

const Test equal("law.glass.every_provider_agrees", [] {
    const auto scene = heap();
    const auto films = [&](Visibility visibility) {
        auto camera = camera_from_above(extent);
        return picture(scene, std::span(&slanting, 1), camera, 128, 1, 0, visibility);
    };
    const auto cpu = films(Visibility::ray_on_cpu), glsl = films(Visibility::ray_in_glsl);
    int different = 0, tinted = 0;
    for (std::size_t i = 0; i < cpu.pixels.size(); ++i) {
        different +=
            std::abs(cpu.pixels[i] - glsl.pixels[i]) > 1e-3f * std::max(cpu.pixels[i], glsl.pixels[i]);
        tinted += i % 4 == 0 && std::abs(cpu.pixels[i] - cpu.pixels[i + 1]) > 1e-3f;
    }
    EXPECT_LE(different, 48) << "of 65536 values";
    EXPECT_GT(tinted, 2000) << "of 16384 pixels: the heap has a colour";
});

// A leaf in the sun that stands behind it: L = E cosθ δ C / π, whichever side is the front.
const Test leaf("law.glass.a_sheet_lit_from_behind_shows_its_colour", [] {
    auto sheet = lambert(vec3(0.8f, 0.6f, 0.4f));
    sheet.diffuse_transmission = 0.3f;
    sheet.diffuse_transmission_color = vec3(0.2f, 0.9f, 0.1f);
    const float cos_i = 0.8f;
    for (const float side : {1.0f, -1.0f}) {
        const scene::Light sun = scene::DirectionalLight{"", {0.6f, -0.8f * side, 0.0f}, vec3(5.0f)};
        const vec3 f = side > 0.0f ? 0.7f * vec3(sheet.base_color) : 0.3f * sheet.diffuse_transmission_color;
        for (const bool is_double_sided : {false, true}) {
            scene::Scene scene;
            sheet.is_double_sided = is_double_sided;
            add_quad(scene, vec3(0.0f), {1.0f, 0, 0}, {0, 0, -1.0f}, sheet);
            auto shaded = scene;
            add_quad(shaded, {-0.75f * 0.5f, -side * -0.5f, 0.0f}, {0.1f, 0, 0}, {0, 0, -1.0f}, lambert());
            for (const Visibility visibility : every_provider) {
                const auto lit =
                    picture(scene, std::span(&sun, 1), camera_from_above(0.5f), 8, 1, 0, visibility);
                const auto texel = lit.at(3, 3);
                expect_near(vec3(texel[0], texel[1], texel[2]), 5.0f * cos_i * f / pi, 1e-5f);
                if (side < 0.0f) { // what stands behind the sheet shadows it
                    const auto dark =
                        picture(shaded, std::span(&sun, 1), camera_from_above(0.5f), 8, 1, 0, visibility);
                    EXPECT_EQ(dark.at(3, 3)[1], 0.0f);
                }
            }
        }
    }
});

// An area light behind the sheet gives what it gives in front of it, by both estimators.
const Test both_sides("law.glass.an_area_light_behind_a_sheet_is_integrated", [] {
    context();
    auto sheet = lambert();
    sheet.diffuse_transmission = 1.0f;
    const auto film = [&](const scene::Material& material, float side, render::Estimator estimator) {
        scene::Scene scene;
        add_quad(scene, vec3(0.0f), {1.0f, 0, 0}, {0, 0, -1.0f}, material);
        const std::vector<scene::Light> lights{scene::RectangleLight{
            "", {0.2f, side, 0.1f}, {0.5f, 0, 0}, {0, 0, side * 0.5f}, vec3(1.0f, 2.0f, 3.0f)}};
        const render::GpuScene gpu_scene(scene, lights, Visibility::ray);
        render::RenderOptions options;
        options.width = options.height = 8;
        options.samples = 64;
        options.estimator = estimator;
        render::Renderer renderer(gpu_scene, camera_from_above(0.5f), options);
        for (int i = 0; i < options.samples; ++i) renderer.add_sample();
        return renderer.read_film();
    };
    for (const auto estimator : {render::Estimator::sampled, render::Estimator::analytic}) {
        const auto front = film(lambert(), 1.0f, estimator), back = film(sheet, -1.0f, estimator);
        EXPECT_GT(front.at(4, 4)[0], 0.01f);
        EXPECT_LT(max_relative_difference(back, front, 1e-3f), 1e-2f);
        EXPECT_EQ(film(lambert(), -1.0f, estimator).at(4, 4)[0], 0.0f) << "an opaque sheet keeps it out";
        EXPECT_EQ(film(sheet, 1.0f, estimator).at(4, 4)[0], 0.0f) << "all goes to the other side";
    }
});

} // namespace
