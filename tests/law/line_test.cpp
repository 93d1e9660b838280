// Points and lines: a few pixels wide whatever the distance, seen, and of no effect on light.
#include "scene/prepare.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

namespace {

using namespace sr;
using namespace sr::testing;
using render::Visibility;

constexpr float width = 3.0f;         // [pixels]: shaders/mesh.vert
constexpr int size = 30;              // of pictures
constexpr float pixels_per_m = 15.0f; // under camera_from_above(1)

constexpr std::array each_provider{Visibility::ray_on_cpu, Visibility::ray_in_glsl, Visibility::map};

scene::Mesh line(vec3 a, vec3 b) {
    scene::Mesh mesh;
    mesh.positions = {a, b};
    mesh.lines = {0, 1};
    return mesh;
}

scene::Mesh point(vec3 place) {
    scene::Mesh mesh;
    mesh.positions = {place};
    mesh.points = {0};
    return mesh;
}

void add(scene::Scene& scene, scene::Mesh mesh, const scene::Material& material = lambert()) {
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.push_back(material);
    scene.meshes.push_back(std::move(mesh));
    scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, mat4(1.0f), ""});
}

scene::Scene only(const scene::Mesh& mesh, const scene::Material& material = lambert()) {
    scene::Scene scene;
    add(scene, mesh, material);
    return scene;
}

/// Sum over the pixels of a channel; of 3 the area that is covered [pixels].
float sum(const image::Image& picture, std::size_t channel) {
    float total = 0.0f;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) total += picture.at(x, y)[channel];
    return total;
}

image::Image from_above(const scene::Scene& scene, int samples = 1) {
    return picture(scene, {}, camera_from_above(1.0f), size, samples);
}

vec4 middle(const image::Image& image) {
    const auto p = image.at(size / 2, size / 2);
    return {p[0], p[1], p[2], p[3]};
}

const Test area("law.line.covers_its_length_times_three_pixels", [] {
    for (const float angle : {0.0f, 0.3f, 0.25f * pi, 1.2f, 0.5f * pi, 2.5f}) {
        const vec3 half = 0.6f * vec3(std::cos(angle), 0.0f, std::sin(angle));
        const auto film = from_above(only(line(-half, half)), 256);
        EXPECT_NEAR(sum(film, 3), 1.2f * pixels_per_m * width, 0.01f * 1.2f * pixels_per_m * width) << angle;
        EXPECT_NEAR(sum(film, 0), sum(film, 3), 1e-3f) << "white is 1 cd/m²";
    }
});

const Test dot("law.line.a_point_covers_three_by_three_pixels", [] {
    for (const vec3 place : {vec3(0, 0, 0), vec3(0.31f, 0.2f, -0.57f)})
        EXPECT_NEAR(sum(from_above(only(point(place)), 256), 3), width * width, 0.01f * width * width);
    const auto film = from_above(only(point({0.5f / pixels_per_m, 0, 0.5f / pixels_per_m})));
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const bool is_near = std::abs(x - size / 2) <= 1 && std::abs(y - size / 2) <= 1;
            EXPECT_EQ(film.at(x, y)[3], is_near ? 1.0f : 0.0f) << x << " " << y;
        }
});

// Below the camera, from behind it to far away: a column from the lower edge of the picture to its vanishing
// point.
const Test perspective("law.line.is_as_wide_near_as_far_and_passes_the_eye", [] {
    scene::Camera camera;
    camera.projection = scene::Perspective{0.5f * pi, std::nullopt, 0.1f, 1000.0f};
    for (const bool is_turned : {false, true}) {
        const vec3 behind(0, -1, 50), far(0, -1, -500);
        const auto film =
            picture(only(is_turned ? line(far, behind) : line(behind, far)), {}, camera, size, 64);
        for (int y = 0; y < size; ++y) {
            float across = 0.0f;
            for (int x = 0; x < size; ++x) across += film.at(x, y)[3];
            const float seen = y < size / 2 ? 0.0f : y == size / 2 ? 1.0f - 0.5f * size / 500.0f : 1.0f;
            EXPECT_NEAR(across, seen * width, 0.06f) << y;
        }
    }
});

const Test unlit("law.line.without_normals_shows_base_colour_and_emission", [] {
    scene::Material material = lambert({0.5f, 0.25f, 1.0f});
    material.emission = {0.0f, 2.0f, 3.0f};
    scene::Mesh mesh = line({-0.5f, 0, 0}, {0.5f, 0, 0});
    mesh.colors = {vec4(0.5f, 1, 1, 1), vec4(0.5f, 1, 1, 1)};
    for (const bool is_point : {false, true}) {
        if (is_point) mesh.positions[0] = vec3(0.0f), mesh.lines.clear(), mesh.points = {0};
        const auto lights = std::vector<scene::Light>{scene::DirectionalLight{}};
        const auto film = picture(only(mesh, material), lights, camera_from_above(1.0f), size);
        EXPECT_EQ(middle(film), vec4(0.25f, 2.25f, 4.0f, 1.0f));
    }
    scene::Scene scene = only(mesh, material);
    EXPECT_TRUE(scene::assign_emitters(scene).empty()) << "it has no area to shine from";
});

const Test hidden("law.line.is_hidden_behind_a_surface_and_whole_on_it", [] {
    scene::Material material = lambert();
    material.is_unlit = true;
    material.base_color = vec4(0, 1, 0, 1);
    for (const float height : {-0.1f, 0.0f, 0.1f})
        for (const bool is_point : {false, true}) {
            auto scene = lambert_plane(2.0f);
            add(scene, is_point ? point({0, height, 0}) : line({-0.5f, height, 0}, {0.5f, height, 0}),
                material);
            const float whole = width * (is_point ? width : pixels_per_m);
            EXPECT_NEAR(sum(from_above(scene, 64), 1), height < 0.0f ? 0.0f : whole, 0.02f * whole) << height;
        }
});

const Test lit("law.line.with_normals_is_lit_and_in_shadow_as_a_surface_is", [] {
    const scene::RectangleLight panel{"", {0, 4, 0}, {0.05f, 0, 0}, {0, 0, 0.05f}, vec3(1600.0f * pi)};
    const std::vector<scene::Light> lights{panel};
    for (const Visibility visibility : each_provider)
        for (const bool is_point : {false, true})
            for (const float side : {1.0f, -1.0f}) {
                scene::Mesh mesh =
                    is_point ? point({0, 0.01f, 0}) : line({-0.5f, 0.01f, 0}, {0.5f, 0.01f, 0});
                mesh.normals.assign(mesh.positions.size(), vec3(0, side, 0));
                auto scene = lambert_plane(1.0f, vec3(0.0f));
                auto camera = camera_from_above(1.0f);
                std::get<scene::Orthographic>(camera.projection).znear = 9.5f; // below the sheet
                const auto surface = picture(lambert_plane(1.0f), lights, camera, size, 16, 0, visibility);
                add(scene, mesh);
                const auto open = picture(scene, lights, camera, size, 16, 0, visibility);
                EXPECT_NEAR(middle(open).x / middle(surface).x, 1.0f, 0.01f) << "whichever way n looks";
                add_quad(scene, {0, 1, 0}, {0.5f, 0, 0}, {0, 0, -0.5f}, lambert());
                const auto shadowed = picture(scene, lights, camera, size, 16, 0, visibility);
                EXPECT_EQ(middle(shadowed).x, 0.0f);
            }
});

const Test no_shadow("law.line.casts_no_shadow", [] {
    const std::vector<scene::Light> lights{
        scene::RectangleLight{"", {0, 4, 0}, {0.05f, 0, 0}, {0, 0, 0.05f}, vec3(1600.0f * pi)}};
    auto camera = camera_from_above(0.1f);
    std::get<scene::Orthographic>(camera.projection).znear = 9.5f;
    for (const Visibility visibility : each_provider) {
        auto scene = lambert_plane(1.0f);
        const auto alone = picture(scene, lights, camera, size, 4, 0, visibility);
        scene::Mesh above = line({-1, 1, 0}, {1, 1, 0});
        above.normals.assign(2, vec3(0, 1, 0));
        add(scene, above);
        const auto with = picture(scene, lights, camera, size, 4, 0, visibility);
        EXPECT_EQ(max_relative_difference(with, alone, 1e-6f), 0.0f);
        EXPECT_GT(middle(picture(only(above), lights, camera_from_above(1.0f), size, 4, 0, visibility)).x,
                  0.0f)
            << "alone, where nothing casts shadows";
    }
});

const Test blended("law.line.blends_once", [] {
    scene::Material material = lambert();
    material.base_color.w = 0.25f;
    material.alpha_mode = scene::AlphaMode::blend;
    for (const bool is_double_sided : {false, true}) {
        material.is_double_sided = is_double_sided;
        EXPECT_EQ(middle(from_above(only(point(vec3(0.0f)), material))), vec4(0.25f));
        EXPECT_EQ(middle(from_above(only(line({-0.5f, 0, 0}, {0.5f, 0, 0}), material))), vec4(0.25f));
    }
});

/// The middle of a picture by another fragment shader.
vec4 middle_by(const scene::Scene& scene, const char* shader) {
    context();
    const render::GpuScene gpu_scene(scene, {});
    render::RenderOptions options;
    options.width = options.height = size;
    options.samples = 1;
    options.shader = shader;
    render::Renderer renderer(gpu_scene, camera_from_above(1.0f), options);
    renderer.add_sample();
    return middle(renderer.read_film());
}

const Test aovs("law.line.is_in_every_picture_of_its_terms", [] {
    for (const bool is_point : {false, true}) {
        auto scene = lambert_plane(0.1f);
        add(scene, is_point ? point({0, 0.5f, 0}) : line({-0.5f, 0.5f, 0}, {0.5f, 0.5f, 0}),
            lambert({0.5f, 0.25f, 1.0f}));
        const vec4 numbers = middle_by(scene, "views/ids_depth.frag");
        EXPECT_EQ(vec2(numbers), vec2(1, 1)) << "object and material";
        EXPECT_NEAR(middle_by(scene, "views/position.frag").y, 0.5f, 1e-6f);
        EXPECT_EQ(vec3(middle_by(scene, "views/albedo.frag")), vec3(0.5f, 0.25f, 1.0f));
        EXPECT_EQ(vec3(middle_by(scene, "views/normal.frag")), vec3(0, 1, 0)) << "it faces the viewer";
        EXPECT_EQ(middle_by(scene, "views/irradiance.frag"), vec4(0, 0, 0, 1));
    }
});

const Test remark("law.line.is_one_remark", [] {
    scene::Scene scene = only(line({0, 0, 0}, {1, 0, 0}));
    add(scene, point({0, 1, 0}));
    const auto stage = scene::prepare_scene(scene, "wires.glb", {});
    ASSERT_EQ(stage.remarks.size(), 1u) << "and no studio, which would light nothing";
    EXPECT_EQ(stage.remarks[0],
              "wires.glb: 2 meshes are points or lines: they are drawn 3 pixels wide at every "
              "distance, and cast no shadows");
    EXPECT_EQ(stage.rig, scene::Rig::none);
});

} // namespace
