// The choice of one light by the light tree (--lights one), and pictures of it against those of all lights.
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/glsl_table.hpp"
#include "support/random.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace sr;
using namespace sr::testing;
using render::LightSampling;
using render::Visibility;

namespace {

/// Lights of every kind, `rounds` times, in and around the box [-2, 2] × [0.5, 2.5] × [-2, 2]. Their powers
/// spread over four decades.
std::vector<scene::Light> mixed_lights(int rounds, std::uint64_t seed) {
    Random random(seed);
    std::vector<scene::Light> lights;
    const auto place = [&] {
        return vec3(random.in_cube(2.0) * glm::dvec3(1, 0.5, 1) + glm::dvec3(0, 1.5, 0));
    };
    const auto amount = [&] {
        return static_cast<float>(random.scale_within(0.01, 100.0)) * vec3(1.0f, 0.8f, 0.5f);
    };
    for (int i = 0; i < rounds; ++i) {
        const mat3 axes = 0.3f * mat3_cast(glm::quat(random.turn()));
        const mat3 more = 0.2f * mat3_cast(glm::quat(random.turn()));
        lights.push_back(scene::PointLight{"", place(), amount()});
        lights.push_back(scene::PointLight{.name = "", .position = place(), .I = amount(), .radius = 0.1f});
        lights.push_back(scene::SpotLight{.name = "",
                                          .position = place(),
                                          .direction = vec3(random.direction()),
                                          .I = amount(),
                                          .inner_angle = 0.2f,
                                          .outer_angle = 0.7f});
        lights.push_back(scene::SpotLight{.name = "",
                                          .position = place(),
                                          .direction = {0, -1, 0},
                                          .I = amount(),
                                          .inner_angle = 0.5f,
                                          .outer_angle = 0.5f});
        lights.push_back(scene::RectangleLight{"", place(), axes[0], axes[1], amount()});
        lights.push_back(scene::RectangleLight{"", place(), more[0], 0.2f * more[1], amount(), true});
        lights.push_back(scene::RectangleLight{"", place(), {0.2f, 0, 0}, {0, 0, 0.3f}, amount()});
        lights.push_back(scene::DiskLight{"", place(), more[2], axes[0] * 0.3f, amount()});
        lights.push_back(scene::SphereLight{"", place(), 0.15f, amount()});
        lights.push_back(scene::TubeLight{"", place(), axes[1], 0.05f, amount()});
        const vec3 c = place();
        lights.push_back(scene::PolygonLight{"", {c + axes[0], c + axes[1], c - axes[0]}, amount()});
        scene::MeshLight mesh{"", {}, amount()};
        for (const vec3 corner : {more[1], -more[1]})
            mesh.triangles.push_back({{c + more[0], c + corner, c + more[2]}, {}});
        lights.push_back(mesh);
        lights.push_back(scene::DirectionalLight{"", vec3(random.direction()), 0.1f * amount()});
    }
    lights.push_back(scene::DirectionalLight{"", glm::normalize(vec3(0.3f, -1.0f, 0.1f)), vec3(0.5f), 0.1f});
    lights.push_back(scene::EnvironmentLight{"", vec3(0.2f)});
    return lights;
}

/// Places in and around the lights, with normals.
std::vector<Row> places(int count, std::uint64_t seed, std::size_t light_count) {
    Random random(seed);
    std::vector<Row> rows;
    for (int i = 0; i < count; ++i) {
        const double reach = random.scale_within(0.1, 100.0);
        rows.push_back({vec4(vec3(random.in_cube(reach)), static_cast<float>(light_count)),
                        vec4(vec3(random.direction()), static_cast<float>(random.unit())),
                        vec4(random.unit(), random.unit(), random.unit(), 0.0)});
    }
    return rows;
}

/// The places as the tree sees them, with peaks of all widths.
const std::string lit_place = R"(
    #include "light/tree.glsl"
    LitPoint lit_place(vec4 a, vec4 b) {
        return LitPoint(a.xyz, b.xyz, normalize(b.yzx + b.xyz), exp(20.0 * b.w - 10.0), exp(-15.0 * b.w));
    })";

const Test sum("law.light_choice.probabilities_sum_to_one", [] {
    const auto lights = mixed_lights(8, 1);
    context();
    const render::GpuScene scene(scene::Scene{}, lights);
    const auto sums = evaluate(lit_place, R"(
        LitPoint lit = lit_place(a, b);
        float sum = 0.0;
        for (int k = 0; k < int(a.w); ++k) sum += p_light(k, lit);
        return vec4(sum);)",
                               places(4096, 2, lights.size()), &scene);
    for (const vec4 answer : sums) ASSERT_NEAR(answer.x, 1.0f, 1e-4f);
});

// A light that shines on x through any of its points has a probability above zero; and the estimate of its
// irradiance that the tree makes of one light is not far below the truth, which bounds the variance.
const Test reach("law.light_choice.every_light_that_shines_can_be_chosen", [] {
    const auto lights = mixed_lights(4, 3);
    context();
    const render::GpuScene scene(scene::Scene{}, lights);
    const auto answers = evaluate(lit_place + "\n#include \"light/sample_light.glsl\"", R"(
        LitPoint lit = lit_place(a, b);
        float lost = 0.0, shining = 0.0, lowest = 1e30;
        for (int k = 0; k < int(a.w); ++k) {
            LightSample s = sample_light(k, a.xyz, c.xy);
            if (!(dot(s.wi, b.xyz) > 0.0) || s.Li_over_p == vec3(0.0)) continue;
            float P = p_light(k, lit);
            shining += 1.0;
            if (!(P > 0.0)) { lost += 1.0; continue; }
            lowest = min(lowest, importance(node_of(leaf_of(k)), lit));
        }
        return vec4(lost, shining, lowest, 0.0);)",
                                  places(8192, 4, lights.size()), &scene);
    float lit = 0.0f;
    for (const vec4 answer : answers) {
        ASSERT_EQ(answer.x, 0.0f);
        ASSERT_GT(answer.z, 0.0f);
        lit += answer.y;
    }
    EXPECT_GT(lit, 8192.0f) << "lights shine";
});

/// Choices of one place by many random numbers: the light, its probability, and what is left of the number.
std::vector<vec4> choices(const render::GpuScene& scene, const Row& place, int count) {
    Random random(5);
    std::vector<Row> rows;
    for (int i = 0; i < count; ++i)
        rows.push_back({place[0], place[1], vec4(random.unit(), random.unit(), random.unit(), 0.0)});
    return evaluate(lit_place, R"(
        LitPoint lit = lit_place(a, b);
        vec2 u = c.xy;
        LightChoice chosen = choose_light(lit, u, c.z);
        return vec4(float(chosen.light), chosen.P, u.x, p_light(chosen.light, lit));)",
                    rows, &scene);
}

std::vector<double> probabilities(const render::GpuScene& scene, const Row& place, std::size_t light_count) {
    std::vector<Row> rows;
    for (std::size_t k = 0; k < light_count; ++k)
        rows.push_back({place[0], place[1], vec4(static_cast<float>(k), 0.0f, 0.0f, 0.0f)});
    std::vector<double> p;
    for (const vec4 answer :
         evaluate(lit_place, "return vec4(p_light(int(c.x), lit_place(a, b)));", rows, &scene))
        p.push_back(answer.x);
    return p;
}

const Test counts("law.light_choice.counts_match_probabilities", [] {
    const auto lights = mixed_lights(4, 6);
    context();
    const render::GpuScene scene(scene::Scene{}, lights);
    constexpr int count = 1 << 16;
    for (const Row& place : places(8, 7, lights.size())) {
        std::vector<double> expected = probabilities(scene, place, lights.size());
        for (double& e : expected) e *= count;
        std::vector<double> counted(lights.size(), 0.0), of_rest(16, 0.0);
        for (const vec4 answer : choices(scene, place, count)) {
            ASSERT_GE(answer.x, 0.0f);
            ASSERT_NEAR(answer.y, answer.w, 1e-4f * answer.w) << "both ways tell one probability";
            counted[static_cast<std::size_t>(answer.x)] += 1.0;
            of_rest[static_cast<std::size_t>(answer.z * 16.0f)] += 1.0;
        }
        EXPECT_LT(chi_squared_excess(expected, counted).value_or(0.0), 5.0);
        EXPECT_LT(chi_squared_excess(std::vector<double>(16, count / 16.0), of_rest).value(), 5.0)
            << "the rest is uniform";
    }
});

/// A room with what shows every term: gloss, normals at all angles, a mirror, a sheet that light comes
/// through, glass, shadows.
scene::Scene room() {
    auto scene = lambert_plane(4.0f);
    scene.materials[0].specular = 1.0f;
    scene.materials[0].roughness = 0.3f;
    scene::Material mirror = lambert();
    mirror.model = scene::Model::mirror;
    scene::Material steel = lambert(vec3(0.9f, 0.8f, 0.6f));
    steel.metallic = 1.0f;
    steel.roughness = 0.15f;
    scene::Material sheet = lambert();
    sheet.diffuse_transmission = 0.6f;
    scene::Material veil = lambert(vec3(0.3f, 0.9f, 0.4f));
    veil.base_color.a = 0.5f;
    veil.alpha_mode = scene::AlphaMode::blend;
    const mat3 turned = mat3_cast(glm::normalize(glm::quat(0.8f, 0.3f, 0.4f, 0.33f)));
    add_box(scene, {-0.9f, 0.4f, -0.9f}, 0.35f * turned, 2, lambert());
    add_box(scene, {0.9f, 0.4f, -0.9f}, 0.35f * turned, 2, steel);
    add_quad(scene, {-0.9f, 0.3f, 0.9f}, {0.6f, 0, 0}, {0, 0.2f, -0.6f}, mirror);
    add_quad(scene, {0.9f, 0.5f, 0.9f}, {0.5f, 0, 0}, {0, 0.2f, -0.5f}, sheet);
    add_quad(scene, {0.0f, 0.3f, 0.0f}, {0.5f, 0, 0}, {0, 0, -0.5f}, veil);
    return scene;
}

/// How a picture is made.
struct Way {
    LightSampling lights;
    Visibility visibility = Visibility::ray_on_cpu;
};

constexpr int size = 32;

render::RenderOptions options_of(const Way& way, int samples, std::uint32_t seed) {
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = samples;
    options.seed = seed;
    options.lights = way.lights;
    return options;
}

/// Means of blocks of 4×4 pixels over several pictures of other seeds, and the variances of these means.
struct Blocks {
    std::vector<double> mean, variance;
};

Blocks blocks_of(const render::GpuScene& scene, const Way& way, int samples, int pictures) {
    constexpr int side = 4, count = size / side;
    Blocks blocks{std::vector<double>(count * count, 0.0), std::vector<double>(count * count, 0.0)};
    const auto programs = render::Renderer::programs(options_of(way, samples, 0));
    for (int seed = 0; seed < pictures; ++seed) {
        render::Renderer renderer(scene, camera_from_above(1.6f),
                                  options_of(way, samples, 1000u + static_cast<std::uint32_t>(seed)),
                                  programs);
        for (int i = 0; i < samples; ++i) renderer.add_sample();
        EXPECT_EQ(renderer.light_choices() > 0, way.lights == LightSampling::one);
        const image::Image film = renderer.read_film();
        for (int block = 0; block < count * count; ++block) {
            double value = 0.0;
            for (int y = 0; y < side; ++y)
                for (int x = 0; x < side; ++x) {
                    const auto texel = film.at(block % count * side + x, block / count * side + y);
                    value += luminance(texel[0], texel[1], texel[2]) / (side * side);
                }
            blocks.mean[static_cast<std::size_t>(block)] += value / pictures;
            blocks.variance[static_cast<std::size_t>(block)] += value * value / pictures;
        }
    }
    for (std::size_t i = 0; i < blocks.mean.size(); ++i)
        blocks.variance[i] =
            std::max(blocks.variance[i] - blocks.mean[i] * blocks.mean[i], 0.0) / (pictures - 1);
    return blocks;
}

/// Expects that both ways have one mean: of all blocks the squares of their differences over their standard
/// errors are near 1 in the mean, and none is large.
void expect_one_mean(const Blocks& a, const Blocks& b) {
    double squares = 0.0, largest = 0.0, sum_a = 0.0, sum_b = 0.0;
    for (std::size_t i = 0; i < a.mean.size(); ++i) {
        const double floor = 1e-4 * b.mean[i]; // rounding, where nothing is random
        const double z =
            (a.mean[i] - b.mean[i]) / std::sqrt(a.variance[i] + b.variance[i] + floor * floor + 1e-30);
        squares += z * z / static_cast<double>(a.mean.size());
        largest = std::max(largest, std::abs(z));
        sum_a += a.mean[i];
        sum_b += b.mean[i];
    }
    EXPECT_LT(squares, 1.8);
    EXPECT_LT(largest, 6.0);
    EXPECT_NEAR(sum_a / sum_b, 1.0, 0.02);
}

const Test same_mean("law.light_choice.one_light_and_all_lights_have_the_same_mean", [] {
    context();
    const auto lights = mixed_lights(1, 8);
    const render::GpuScene scene(room(), lights, Visibility::ray_on_cpu);
    expect_one_mean(blocks_of(scene, {LightSampling::one}, 16, 20),
                    blocks_of(scene, {LightSampling::all}, 8, 8));
});

/// The film of the lights [first, end).
image::Image film_of(const render::GpuScene& scene, const Way& way, int first, int end) {
    render::Renderer renderer(scene, camera_from_above(1.6f), options_of(way, 4, 3));
    renderer.use_lights(first, end);
    for (int i = 0; i < 4; ++i) renderer.add_sample();
    return renderer.read_film();
}

// Layers of the lights add up to the picture: each keeps the samples that chose it.
const Test layers("law.light_choice.superposition", [] {
    context();
    const auto lights = mixed_lights(1, 10);
    const render::GpuScene scene(room(), lights, Visibility::ray_on_cpu);
    const int count = static_cast<int>(lights.size());
    const image::Image together = film_of(scene, {LightSampling::one}, 0, count);
    const image::Image dark = film_of(scene, {LightSampling::one}, 0, 0);
    image::Image sum = dark;
    for (int k = 0; k < count; ++k) {
        const image::Image alone = film_of(scene, {LightSampling::one}, k, k + 1);
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += alone.pixels[i] - dark.pixels[i];
    }
    EXPECT_LT(max_relative_difference(together, sum, 1e-3f), 1e-4f);
});

const Test providers("law.light_choice.both_providers_of_shadows_agree", [] {
    context();
    const auto lights = mixed_lights(1, 11);
    const auto pixels = [&](Visibility visibility) {
        const render::GpuScene scene(room(), lights, visibility);
        return film_of(scene, {LightSampling::one, visibility}, 0, static_cast<int>(lights.size())).pixels;
    };
    const auto by_cpu = pixels(Visibility::ray_on_cpu), in_glsl = pixels(Visibility::ray_in_glsl);
    std::size_t different = 0;
    for (std::size_t i = 0; i < by_cpu.size(); ++i)
        different += std::abs(by_cpu[i] - in_glsl[i]) > 1e-3f * std::abs(in_glsl[i]) + 1e-5f ? 1 : 0;
    EXPECT_LT(different, by_cpu.size() / 200) << "rays that graze an edge";
});

// One light, many lights that send nothing, and none at all.
const Test few("law.light_choice.few_lights", [] {
    context();
    const scene::Scene plane = lambert_plane(4.0f);
    const auto shown = [&](const std::vector<scene::Light>& lights, LightSampling sampling) {
        const render::GpuScene scene(plane, lights, Visibility::ray_on_cpu);
        return film_of(scene, {sampling}, 0, static_cast<int>(lights.size()));
    };
    std::vector<scene::Light> lights{scene::PointLight{"", {0.0f, 1.0f, 0.0f}, vec3(1.0f)}};
    const image::Image alone = shown(lights, LightSampling::all);
    EXPECT_LT(max_relative_difference(shown(lights, LightSampling::one), alone, 1e-6f), 1e-5f);
    for (int i = 0; i < 20; ++i)
        lights.push_back(scene::SphereLight{"", {0.0f, 1.0f, 0.0f}, 0.1f, vec3(0.0f)});
    EXPECT_LT(max_relative_difference(shown(lights, LightSampling::one), alone, 1e-6f), 1e-5f);
    lights.erase(lights.begin());
    const image::Image dark = shown(lights, LightSampling::one);
    for (std::size_t i = 0; i < dark.pixels.size(); i += 4) ASSERT_EQ(dark.pixels[i], 0.0f);
    shown({}, LightSampling::one);
});

} // namespace
