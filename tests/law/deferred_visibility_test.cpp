// Pictures whose surfaces are shaded once, against those that are shaded twice (Renderer::defers_visibility).
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

using namespace sr;
using namespace sr::testing;
using render::Visibility;

namespace {

constexpr int size = 48;

scene::Material of(vec3 rho, void (*change)(scene::Material&)) {
    scene::Material material = lambert(rho);
    change(material);
    return material;
}

/// Boxes of several materials on a plane.
scene::Scene boxes() {
    auto scene = lambert_plane(3.0f, vec3(0.7f, 0.6f, 0.5f));
    add_box(scene, {-0.9f, 0.3f, 0.2f}, mat3(0.3f), 1, lambert(vec3(0.2f, 0.8f, 0.3f)));
    add_box(scene, {0.1f, 0.5f, -0.7f}, mat3(0.4f), 1, of(vec3(0.9f), [](scene::Material& m) {
                m.metallic = 1.0f;
                m.roughness = 0.3f;
            }));
    add_box(scene, {0.9f, 0.2f, 0.6f}, mat3(0.25f), 1, of(vec3(0.6f), [](scene::Material& m) {
                m.specular = 1.0f;
                m.roughness = 0.2f;
                m.emission = vec3(0.3f, 0.2f, 0.1f);
            }));
    return scene;
}

/// The same, one of them under a sheet of red glass. A frame then takes the sums before the sheet covers
/// them; without it they stay apart.
scene::Scene boxes_and_sheet() {
    auto scene = boxes();
    add_quad(scene, {0.9f, 0.9f, 0.6f}, {0.5f, 0, 0}, {0, 0, -0.5f},
             of(vec3(0.9f, 0.2f, 0.2f), [](scene::Material& m) {
                 m.alpha_mode = scene::AlphaMode::blend;
                 m.base_color.w = 0.5f;
                 m.is_double_sided = true;
             }));
    return scene;
}

/// The same under a pane of green glass, which multiplies what is behind it by a second colour.
scene::Scene boxes_and_pane() {
    auto scene = boxes();
    add_quad(scene, {-0.6f, 1.0f, 0.3f}, {0.6f, 0, 0}, {0, 0, -0.6f},
             of(vec3(0.3f, 0.9f, 0.4f), [](scene::Material& m) {
                 m.specular = 1.0f;
                 m.transmission = 0.9f;
                 m.is_double_sided = true;
             }));
    return scene;
}

std::vector<scene::Light> lights(int count) {
    std::vector<scene::Light> lights;
    for (int i = 0; i < count; ++i) {
        const float angle = 2.4f * static_cast<float>(i);
        const vec3 at(1.5f * std::cos(angle), 1.4f + 0.03f * static_cast<float>(i), 1.5f * std::sin(angle));
        switch (i % 4) {
        case 0:
            lights.push_back(scene::RectangleLight{"", at, {0.3f, 0, 0}, {0, 0, 0.3f}, vec3(5.0f)});
            break;
        case 1: lights.push_back(scene::PointLight{"", at, vec3(1.0f, 0.8f, 0.5f)}); break;
        case 2: lights.push_back(scene::SphereLight{"", at, 0.2f, vec3(3.0f)}); break;
        default: lights.push_back(scene::DirectionalLight{"", -glm::normalize(at), vec3(0.4f, 0.5f, 0.6f)});
        }
    }
    return lights;
}

/// Renders 4 samples, in parts of 7 rows. `is_foreign`: with a folder of shaders that is not the renderer's,
/// and brings nothing.
image::Image film_of(const scene::Scene& scene, std::span<const scene::Light> lights,
                     render::RenderOptions options, bool is_foreign) {
    options.width = options.height = size;
    options.samples = 4;
    if (is_foreign)
        options.shader_path.insert(options.shader_path.begin(), glsl::Root::memory("nothing", {}));
    const render::GpuScene gpu_scene(scene, lights, Visibility::ray_on_cpu);
    render::Renderer renderer(gpu_scene, camera_from_above(1.6f), options);
    EXPECT_EQ(renderer.defers_visibility(), !is_foreign);
    renderer.compile();
    const std::size_t programs = renderer.program_count();
    for (int i = 0; i < options.samples; ++i)
        while (!renderer.add_rows(7)) {
        }
    EXPECT_EQ(renderer.program_count(), programs) << "compile() left out a program";
    EXPECT_GT(renderer.traced_rays()->count, 0u);
    return renderer.read_film();
}

void expect_equal(std::span<const scene::Light> lights, const render::RenderOptions& options) {
    for (const scene::Scene& scene : {boxes(), boxes_and_sheet(), boxes_and_pane()}) {
        const auto once = film_of(scene, lights, options, false),
                   twice = film_of(scene, lights, options, true);
        EXPECT_LT(max_relative_difference(once, twice, 1e-3f), 1e-5f) << "sums of floats in another order";
        for (std::size_t i = 3; i < once.pixels.size(); i += 4) EXPECT_EQ(once.pixels[i], twice.pixels[i]);
    }
}

/// The film's mean as shaders can read it, the first row on top.
image::Image shown(const render::Renderer& renderer) {
    image::Image film(size, size, 4);
    std::vector<float> sums(film.pixels.size());
    renderer.film_sum().bind(0);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, sums.data());
    const std::vector<int> samples = renderer.pixel_samples();
    constexpr std::size_t row = std::size_t{4} * size;
    for (std::size_t i = 0; i < sums.size(); ++i)
        film.pixels[i] =
            sums[sums.size() - row - i / row * row + i % row] / static_cast<float>(samples[i / 4]);
    return film;
}

/// Runs a test where the driver can shade once.
void where_offered(void (*check)()) {
    context();
    if (!render::DeferredVisibility::is_offered())
        GTEST_SKIP() << "this driver has no shader storage buffers";
    check();
}

const Test plain("law.shadow.once.equals_twice", [] { where_offered([] { expect_equal(lights(4), {}); }); });

// More lights than one shading takes; their sums come together before the frame has them.
const Test many("law.shadow.once.many_lights", [] { where_offered([] { expect_equal(lights(37), {}); }); });

const Test chosen("law.shadow.once.chosen_lights", [] {
    where_offered([] {
        render::RenderOptions options;
        options.lights = render::LightSampling::one;
        expect_equal(lights(37), options);
    });
});

const Test analytic("law.shadow.once.analytic", [] {
    where_offered([] {
        render::RenderOptions options;
        options.estimator = render::Estimator::analytic;
        expect_equal(lights(6), options);
    });
});

// A shader reads the film that is read back: after each sample, while some pixels rest, from the start again,
// and under no light.
const Test texture("law.shadow.once.shaders_read_the_same_film", [] {
    where_offered([] {
        for (const scene::Scene& scene : {boxes(), boxes_and_sheet()}) {
            render::RenderOptions options;
            options.width = options.height = size;
            options.estimates_error = true;
            const std::vector<scene::Light> lit = lights(4);
            const render::GpuScene gpu_scene(scene, lit, Visibility::ray_on_cpu);
            render::Renderer renderer(gpu_scene, camera_from_above(1.6f), options);
            const auto expect_same = [&] {
                const image::Image film = renderer.read_film();
                EXPECT_LT(max_relative_difference(shown(renderer), film, 1e-3f), 1e-6f);
                EXPECT_EQ(renderer.read_pixel(20, 30)[0], film.at(20, 30)[0]);
            };
            for (int i = 0; i < 3; ++i) {
                renderer.add_sample();
                expect_same();
            }
            render::PixelMask rest(std::size_t{size} * size, 0);
            std::fill_n(rest.begin(), rest.size() / 3, std::uint8_t{1});
            renderer.freeze(rest);
            renderer.add_sample();
            expect_same();
            renderer.use_lights(0, 0);
            renderer.add_sample();
            expect_same();
            renderer.clear();
            renderer.add_sample();
            expect_same();
        }
    });
});

const Test window("law.shadow.once.a_window", [] {
    where_offered([] {
        render::RenderOptions options;
        options.window = render::PixelRect{5, 9, 31, 17};
        options.estimates_error = true;
        expect_equal(lights(4), options);
    });
});

} // namespace
