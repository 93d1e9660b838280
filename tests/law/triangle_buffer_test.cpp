// Pictures whose finely meshed surfaces are shaded pixel by pixel, against those that rasterisation shades
// triangle by triangle (render/triangle_buffer.hpp).
#include "render/triangle_buffer.hpp"

#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <array>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

using namespace sr;
using namespace sr::testing;
using render::Visibility;

namespace {

constexpr int width = 96, height = 64;

/// A ball of radius 1 with every vertex array: 2 · 24 · 16 triangles.
scene::Mesh ball() {
    constexpr int columns = 24, rows = 16;
    scene::Mesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const vec2 uv(static_cast<float>(i) / columns, static_cast<float>(j) / rows);
            const float phi = 2.0f * std::numbers::pi_v<float> * uv.x,
                        theta = std::numbers::pi_v<float> * uv.y;
            const vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
            mesh.positions.push_back(n);
            mesh.normals.push_back(n);
            mesh.tangents.emplace_back(-std::sin(phi), 0.0f, std::cos(phi), 1.0f);
            mesh.texcoords[0].push_back(3.0f * uv);
            mesh.texcoords[1].push_back(vec2(uv.y, uv.x * uv.x));
            mesh.colors.emplace_back(0.5f + 0.5f * uv.x, 1.0f, 1.0f - 0.5f * uv.y, 1.0f);
        }
    for (std::uint32_t j = 0; j < rows; ++j)
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * (columns + 1) + i, c = a + columns + 1;
            for (const std::uint32_t corner : {a, a + 1, c, a + 1, c + 1, c}) mesh.indices.push_back(corner);
        }
    return mesh;
}

/// Texels that change from one to the next, so that their mip levels differ.
scene::TextureImage stripes() {
    constexpr int size = 64;
    std::vector<std::uint8_t> texels;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (const int channel :
                 {x * 3 + y, 255 - x, 128 + (x + 2 * y) % 100, (x / 8 + y / 8) % 2 ? 255 : 0})
                texels.push_back(static_cast<std::uint8_t>(channel % 256));
    return {"stripes", size, size, texels};
}

void add(scene::Scene& scene, const mat4& world_from_object, const scene::Material& material,
         scene::Mesh mesh = ball()) {
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene::Instance& instance = scene.instances.emplace_back();
    instance.mesh = static_cast<int>(scene.meshes.size());
    instance.world_from_object = world_from_object;
    scene.meshes.push_back(std::move(mesh));
}

mat4 placed(vec3 at, vec3 scale) { return glm::scale(glm::translate(mat4(1.0f), at), scale); }

/// Balls with textures, a mirrored one, one with holes through which its inside is seen, two in one place.
/// `with_quads`: and plain quads in front of and behind them, so that not all surfaces are finely meshed.
scene::Scene balls(bool with_quads = true) {
    scene::Scene scene;
    scene.images.push_back(stripes());
    scene.textures = {{0, {}, scene::ColorSpace::srgb}, {0, {}, scene::ColorSpace::linear}};
    scene::Material textured;
    textured.roughness = 0.6f;
    textured.base_color_texture = {0, 1, mat3(glm::rotate(mat4(1.0f), 0.4f, vec3(0, 0, 1))) * 2.0f};
    textured.normal_texture = {1, 0};
    textured.metallic_roughness_texture = {1, 0};
    textured.emission = vec3(0.1f);
    textured.emission_texture = {0, 0};
    scene::Material with_holes = textured;
    with_holes.alpha_mode = scene::AlphaMode::mask;
    with_holes.is_double_sided = true;
    with_holes.base_color_texture = {0, 0};
    add(scene, placed({-1.0f, 0.8f, 0.0f}, {0.9f, 0.6f, 0.8f}), textured);
    add(scene, placed({0.9f, 0.7f, 0.2f}, {-0.8f, 0.7f, 0.8f}), textured); // mirrored
    add(scene, placed({0.0f, 0.9f, 1.2f}, vec3(0.5f)), with_holes);
    for (const vec3 rho : {vec3(0.7f, 0.3f, 0.2f), vec3(0.1f, 0.3f, 0.9f)})
        add(scene, placed({0.2f, 0.4f, -1.2f}, vec3(0.4f)), lambert(rho));
    if (!with_quads) return scene;
    add_quad(scene, {}, {3, 0, 0}, {0, 0, -3}, lambert(vec3(0.6f)));
    add_quad(scene, {0.5f, 1.2f, 1.9f}, {0.2f, 0, 0}, {0, 0.4f, 0}, lambert({0.2f, 0.5f, 0.8f}));
    return scene;
}

const std::vector<scene::Light>& lamps() {
    static const std::vector<scene::Light> lamps{
        scene::PointLight{"", {1.5f, 3.0f, 2.0f}, vec3(40.0f)},
        scene::DirectionalLight{"", {0.3f, -1.0f, -0.4f}, vec3(2.0f)}};
    return lamps;
}

scene::Camera looking(vec3 from, vec3 to, const std::variant<scene::Perspective, scene::Orthographic>& lens) {
    scene::Camera camera;
    camera.world_from_camera = glm::inverse(glm::lookAt(from, to, vec3(0, 1, 0)));
    camera.projection = lens;
    return camera;
}

/// `is_foreign`: with a folder of shaders that is not the renderer's, and brings nothing.
image::Image film_of(const scene::Scene& scene, const scene::Camera& camera, Visibility visibility,
                     render::RenderOptions options, bool is_foreign) {
    options.width = width;
    options.height = height;
    options.samples = 3;
    if (is_foreign)
        options.shader_path.insert(options.shader_path.begin(), glsl::Root::memory("nothing", {}));
    const render::GpuScene gpu_scene(scene, lamps(), visibility);
    render::Renderer renderer(gpu_scene, camera, options);
    EXPECT_EQ(renderer.shades_pixels(), !is_foreign);
    renderer.compile();
    const std::size_t programs = renderer.program_count();
    for (int i = 0; i < options.samples; ++i)
        while (!renderer.add_rows(23)) {
        }
    EXPECT_EQ(renderer.program_count(), programs) << "compile() left out a program";
    return renderer.read_film();
}

void expect_equal(const scene::Camera& camera, Visibility visibility,
                  const render::RenderOptions& options = {}, const scene::Scene& scene = balls()) {
    context();
    const render::GpuScene probe(scene, lamps(), Visibility::none);
    if (!render::TriangleBuffer::is_useful(probe)) GTEST_SKIP() << "this driver does not run on the CPU";
    const image::Image by_pixel = film_of(scene, camera, visibility, options, false),
                       by_triangle = film_of(scene, camera, visibility, options, true);
    EXPECT_LT(max_relative_difference(by_pixel, by_triangle, 1e-2f), 2e-3f) << "places and slopes, rounded";
    for (std::size_t i = 3; i < by_pixel.pixels.size(); i += 4)
        EXPECT_EQ(by_pixel.pixels[i], by_triangle.pixels[i]) << "coverage";
}

const scene::Perspective lens{.yfov = 1.0f, .aspect_ratio = {}, .zfar = {}};

const Test perspective("law.shading.by_pixel.perspective", [] {
    expect_equal(looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens), Visibility::none);
});

const Test orthographic("law.shading.by_pixel.orthographic", [] {
    expect_equal(looking({2.0f, 3.0f, 5.0f}, {0, 0.6f, 0}, scene::Orthographic{2.4f, 1.6f, 0.0f, 20.0f}),
                 Visibility::none);
});

// Triangles reach behind the camera.
const Test inside("law.shading.by_pixel.inside_a_ball", [] {
    expect_equal(looking({0.1f, 0.95f, 1.25f}, {0.5f, 0.8f, 0.0f}, lens), Visibility::none);
});

const Test shadowed("law.shading.by_pixel.shadows", [] {
    expect_equal(looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens), Visibility::ray_on_cpu);
});

const Test mapped("law.shading.by_pixel.depth_maps", [] {
    expect_equal(looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens), Visibility::map);
});

const Test window("law.shading.by_pixel.a_window", [] {
    render::RenderOptions options;
    options.window = render::PixelRect{11, 7, 60, 41};
    expect_equal(looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens), Visibility::ray_on_cpu, options);
});

// Samples are then added to the film as they are drawn, and not by way of a frame.
const Test alone("law.shading.by_pixel.nothing_else_is_drawn", [] {
    for (const Visibility visibility : {Visibility::none, Visibility::ray_on_cpu}) {
        render::RenderOptions options;
        options.estimates_error = visibility == Visibility::none;
        options.background = vec3(0.1f, 0.2f, 0.3f);
        expect_equal(looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens), visibility, options, balls(false));
    }
});

/// Renders a few samples, of which some pixels lack the last ones.
void add_samples(render::Renderer& renderer) {
    for (int i = 0; i < 3; ++i) renderer.add_sample();
    render::PixelMask rest(std::size_t{width} * height, 0);
    for (std::size_t i = 0; i < rest.size(); i += 5) rest[i] = 1;
    renderer.freeze(rest);
    for (int i = 0; i < 2; ++i) renderer.add_sample();
}

/// For scenes of both kinds, whose films have halves or not, and whose shadow rays the CPU traces.
void for_each_kind(const auto& expect) {
    context();
    const scene::Camera camera = looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens);
    for (const bool with_quads : {false, true}) {
        const scene::Scene scene = balls(with_quads);
        const render::GpuScene gpu_scene(scene, lamps(), Visibility::ray_on_cpu);
        for (const bool has_halves : {false, true}) {
            SCOPED_TRACE(fmt::format("quads: {}, halves: {}", with_quads, has_halves));
            render::RenderOptions options;
            options.width = width;
            options.height = height;
            options.estimates_error = has_halves;
            expect(gpu_scene, camera, options);
        }
    }
}

// Films are not cleared where their first sample takes the place of what they hold.
const Test starts_over("law.shading.by_pixel.a_film_that_starts_over_keeps_nothing", [] {
    for_each_kind(
        [](const render::GpuScene& scene, const scene::Camera& camera, const render::RenderOptions& options) {
            render::Renderer fresh(scene, camera, options);
            add_samples(fresh);
            render::Renderer used(scene, looking({-4.0f, 1.0f, 2.0f}, {0, 0.6f, 0}, lens), options);
            add_samples(used);
            used.look_from(camera);
            used.add_rows(20); // half a sample
            used.clear();
            add_samples(used);
            EXPECT_EQ(fresh.read_film().pixels, used.read_film().pixels);
            used.repeat(); // pixels rest as they did
            for (int i = 0; i < 5; ++i) used.add_sample();
            EXPECT_EQ(fresh.read_film().pixels, used.read_film().pixels);
            if (options.estimates_error) {
                EXPECT_EQ(fresh.read_first_half().pixels, used.read_first_half().pixels);
            }
        });
});

// The viewer shows what is read back, and samples go on after that.
const Test shown("law.shading.by_pixel.shaders_read_the_sum_that_is_read_back", [] {
    for_each_kind(
        [](const render::GpuScene& scene, const scene::Camera& camera, const render::RenderOptions& options) {
            render::Renderer renderer(scene, camera, options);
            const auto expect_same = [&] {
                const image::Image film = renderer.read_film();
                std::vector<vec4> sum(film.pixels.size() / 4);
                renderer.film_sum().bind(0);
                glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, sum.data());
                const std::vector<int> samples = renderer.pixel_samples();
                for (std::size_t i = 0; i < sum.size(); ++i) {
                    const std::size_t from_below = (height - 1 - i / width) * width + i % width;
                    for (int channel = 0; channel < 4; ++channel) {
                        const float mean = film.pixels[4 * i + static_cast<std::size_t>(channel)];
                        ASSERT_NEAR(sum[from_below][channel] / static_cast<float>(samples[i]), mean,
                                    1e-6f + 1e-6f * mean);
                    }
                }
                const image::Image again = renderer.read_film();
                EXPECT_LT(max_relative_difference(again, film, 1e-2f), 1e-5f) << "reading takes nothing away";
            };
            add_samples(renderer);
            expect_same();
            renderer.add_sample();
            expect_same();
        });
});

// A pixel that has enough samples keeps what it has.
const Test frozen("law.shading.by_pixel.frozen_pixels_rest", [] {
    context();
    const scene::Scene scene = balls();
    const render::GpuScene gpu_scene(scene, lamps(), Visibility::none);
    if (!render::TriangleBuffer::is_useful(gpu_scene)) GTEST_SKIP() << "this driver does not run on the CPU";
    render::RenderOptions options;
    options.width = width;
    options.height = height;
    render::Renderer renderer(gpu_scene, looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens), options);
    renderer.add_sample();
    const image::Image before = renderer.read_film();
    render::PixelMask rest(std::size_t{width} * height, 0);
    for (std::size_t i = 0; i < rest.size(); i += 3) rest[i] = 1;
    renderer.freeze(rest);
    for (int i = 0; i < 3; ++i) renderer.add_sample();
    const image::Image after = renderer.read_film();
    int changed = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        if (rest[i])
            EXPECT_EQ(before.pixels[4 * i], after.pixels[4 * i]);
        else
            changed += before.pixels[4 * i] != after.pixels[4 * i];
    }
    EXPECT_GT(changed, width) << "the others go on";
});

/// The pixels of the right quarter and of a row that crosses the picture.
bool stays_open(int column, int row) { return column >= 3 * width / 4 || row == 40; }

// Triangles that only frozen pixels see are left out. The others have what they have if none is.
const Test left_out("law.shading.by_pixel.frozen_pixels_change_no_other", [] {
    context();
    render::PixelMask rest(std::size_t{width} * height, 0);
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            rest[static_cast<std::size_t>(row * width + column)] = stays_open(column, row) ? 0 : 1;
    const std::array cameras{
        looking({0.5f, 2.0f, 5.0f}, {0, 0.6f, 0}, lens),
        looking({0.1f, 0.95f, 1.25f}, {0.5f, 0.8f, 0.0f}, lens),
        looking({2.0f, 3.0f, 5.0f}, {0, 0.6f, 0}, scene::Orthographic{2.4f, 1.6f, 0.0f, 20.0f})};
    for (const Visibility visibility : {Visibility::ray_on_cpu, Visibility::map}) {
        const render::GpuScene gpu_scene(balls(), lamps(), visibility);
        for (const scene::Camera& camera : cameras) {
            render::RenderOptions options;
            options.width = width;
            options.height = height;
            options.maps.size = 64;
            render::Renderer partly(gpu_scene, camera, options), whole(gpu_scene, camera, options);
            for (int i = 0; i < 5; ++i) {
                if (i == 2) partly.freeze(rest);
                partly.add_sample();
                whole.add_sample();
            }
            const image::Image some = partly.read_film(), all = whole.read_film();
            partly.repeat(); // pixels rest as they did
            for (int i = 0; i < 5; ++i) partly.add_sample();
            EXPECT_EQ(partly.read_film().pixels, some.pixels) << "all are open again";
            for (std::size_t i = 0; i < rest.size(); ++i)
                for (std::size_t channel = 0; channel < 4 && rest[i] == 0; ++channel)
                    ASSERT_EQ(some.pixels[4 * i + channel], all.pixels[4 * i + channel]) << "pixel " << i;
        }
    }
});

} // namespace
