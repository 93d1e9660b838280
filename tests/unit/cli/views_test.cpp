#include "core/file.hpp"
#include "image/colormap.hpp"
#include "output/variables.hpp"
#include "render/renderer.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace sr;
using namespace sr::testing;

namespace {

constexpr int view_size = 17; // the middle pixel looks at the origin

/// The middle pixel of a view of the scene from above.
std::vector<float> middle_of(const char* view, const scene::Scene& scene, vec3 light) {
    context();
    const std::vector<scene::Light> lights{scene::PointLight{"", light, vec3(1.0f)}};
    const render::GpuScene gpu_scene(scene, lights);
    render::RenderOptions options;
    options.width = options.height = view_size;
    options.samples = 1;
    options.shader = output::view_named(view)->shader;
    render::Renderer renderer(gpu_scene, camera_from_above(1.0f), options);
    renderer.add_sample();
    const image::Image numbers = output::numbers_of(*output::view_named(view), renderer.read_film());
    const auto pixel = numbers.at(view_size / 2, view_size / 2);
    return {pixel.begin(), pixel.end()};
}

// Normals bent towards a light below the plane let it in; a second plane in between keeps it out; straight
// ones see neither.
const Test leaks("unit.cli.views.leaks_are_told_from_what_is_kept_out", [] {
    const vec3 below(3.0f, -1.0f, 0.0f);
    scene::Scene plane = lambert_plane(1.0f);
    EXPECT_EQ(middle_of("leaks", plane, below), (std::vector<float>{0, 0, 0, 1}));
    for (vec3& n : plane.meshes[0].normals) n = vec3(0.8f, 0.6f, 0.0f);
    EXPECT_EQ(middle_of("leaks", plane, below), (std::vector<float>{1, 1, 0, 1}));
    EXPECT_EQ(middle_of("leaks", plane, {3.0f, 1.0f, 0.0f}), (std::vector<float>{0, 0, 0, 1}));
    add_quad(plane, {0, -0.1f, 0}, {1, 0, 0}, {0, 0, -1}, lambert());
    EXPECT_EQ(middle_of("leaks", plane, below), (std::vector<float>{0, 1, 0, 1}));
});

const Test terms("unit.cli.views.are_the_terms", [] {
    const vec3 light(0.75f, 1.0f, 0.0f); // 3-4-5
    const scene::Scene plane = lambert_plane(2.0f);
    EXPECT_NEAR(middle_of("cosine", plane, light)[0], 0.8f, 1e-4f);
    EXPECT_EQ(middle_of("visibility", plane, light)[0], 1.0f);
    EXPECT_NEAR(middle_of("irradiance", plane, light)[0], 0.8f / 1.5625f, 1e-4f);
    EXPECT_NEAR(middle_of("luminance", plane, light)[1], 0.8f / 1.5625f / pi, 1e-4f);
    EXPECT_EQ(output::view_named("beauty"), nullptr);
});

// A square of two triangles fills the picture: its diagonal is an edge, and nothing else is.
const Test wireframe("unit.cli.views.the_wireframe_has_the_edges", [] {
    context();
    const scene::Scene square = lambert_plane(1.0f);
    const std::vector<scene::Light> no_lights;
    const render::GpuScene gpu_scene(square, no_lights);
    render::RenderOptions options;
    options.width = options.height = view_size;
    options.samples = 1;
    options.shader = output::view_named("wireframe")->shader;
    render::Renderer renderer(gpu_scene, camera_from_above(1.0f), options);
    renderer.add_sample();
    const image::Image film = renderer.read_film();
    const auto edge_at = [&](int x, int y) { return film.at(x, y)[0]; };
    const bool falls = edge_at(4, 4) > 0.5f; // the diagonal goes down to the right
    for (int i = 2; i < view_size - 2; ++i) {
        const int on_edge = falls ? i : view_size - 1 - i;
        EXPECT_NEAR(edge_at(on_edge, i), 1.0f, 1e-3f) << i;
        for (int x = 2; x < view_size - 2; ++x) {
            const float distance = std::abs(static_cast<float>(x - on_edge)) / std::sqrt(2.0f); // [pixels]
            EXPECT_NEAR(edge_at(x, i), std::clamp(1.25f - distance, 0.0f, 1.0f), 1e-3f) << x << "," << i;
        }
    }
});

// Where triangles are smaller than pixels, every pixel lies on an edge: the mesh is grey, and darker than the
// square of two triangles at its edge.
const Test dense_wireframe("unit.cli.views.the_wireframe_of_a_dense_mesh_is_grey", [] {
    scene::Scene box;
    add_box(box, {0.0f, -1.0f, 0.0f}, mat3(1.0f), 2 * view_size, lambert());
    const std::vector<float> middle = middle_of("wireframe", box, {0.0f, 1.0f, 0.0f});
    EXPECT_GT(middle[0], 0.1f) << "it is still seen";
    EXPECT_LT(middle[0], 0.3f);
    EXPECT_EQ(middle[3], 1.0f);
});

// Planes below each other: those that face away are culled, unless they are double-sided, and blended ones
// count.
const Test overdraw("unit.cli.views.overdraw_counts_surfaces", [] {
    const auto count = [](const scene::Scene& scene) { return middle_of("overdraw", scene, vec3(0, 1, 0)); };
    scene::Scene planes = lambert_plane(1.0f);
    EXPECT_EQ(count(planes), (std::vector<float>{1, 1, 1, 1}));
    add_quad(planes, {0, -0.1f, 0}, {1, 0, 0}, {0, 0, -1}, lambert());
    EXPECT_EQ(count(planes), (std::vector<float>{2, 2, 2, 1}));
    scene::Material other = lambert();
    add_quad(planes, {0, -0.2f, 0}, {1, 0, 0}, {0, 0, 1}, other);
    EXPECT_EQ(count(planes), (std::vector<float>{2, 2, 2, 1}));
    other.is_double_sided = true;
    add_quad(planes, {0, -0.3f, 0}, {1, 0, 0}, {0, 0, 1}, other);
    EXPECT_EQ(count(planes), (std::vector<float>{3, 3, 3, 1}));
    other.alpha_mode = scene::AlphaMode::blend;
    other.base_color.a = 0.25f;
    add_quad(planes, {0, 0.1f, 0}, {1, 0, 0}, {0, 0, -1}, other);
    EXPECT_EQ(count(planes), (std::vector<float>{4, 4, 4, 1}));
});

const Test surfaces("unit.cli.views.are_the_values_of_the_material", [] {
    scene::Scene plane = lambert_plane(2.0f);
    plane.materials[0].roughness = 0.25f;
    plane.materials[0].metallic = 0.5f;
    plane.meshes[0].texcoords[0].assign(plane.meshes[0].positions.size(), vec2(0.25f, 1.75f));
    const vec3 light(0.0f, 1.0f, 0.0f);
    EXPECT_EQ(middle_of("roughness", plane, light), (std::vector<float>{0.25f, 0.25f, 0.25f, 1.0f}));
    EXPECT_EQ(middle_of("metallic", plane, light), (std::vector<float>{0.5f, 0.5f, 0.5f, 1.0f}));
    EXPECT_EQ(middle_of("uv", plane, light), (std::vector<float>{0.25f, 0.75f, 0.0f, 1.0f}));
    const std::vector<float> one = middle_of("triangles", plane, light);
    std::swap(plane.meshes[0].indices[0], plane.meshes[0].indices[3]);
    std::swap(plane.meshes[0].indices[1], plane.meshes[0].indices[4]);
    std::swap(plane.meshes[0].indices[2], plane.meshes[0].indices[5]);
    EXPECT_NE(middle_of("triangles", plane, light), one) << "the other triangle is there now";
});

// The legend in src/image/README.md holds in every picture.
const Test scale("unit.cli.views.luminance_has_one_scale", [] {
    image::Image film(5, 1, 3);
    const float L[]{100.0f, 31.6228f, 0.0f, 1e9f, std::numeric_limits<float>::quiet_NaN()};
    const vec3 expected[]{vec3(0x1f, 0x9e, 0x89), 0.5f * (vec3(0x26, 0x82, 0x8e) + vec3(0x1f, 0x9e, 0x89)),
                          vec3(0x44, 0x01, 0x54), vec3(0xfd, 0xe7, 0x25), vec3(255, 0, 255)};
    for (int x = 0; x < 5; ++x)
        for (std::size_t c = 0; c < 3; ++c) film.at(x, 0)[c] = L[x];
    const image::Image colors = image::luminance_colors(film);
    for (int x = 0; x < 5; ++x)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(colors.at(x, 0)[static_cast<std::size_t>(c)] * 255.0f, expected[x][c], 0.03f) << x;
});

std::string readme_row(const output::Variable& variable) {
    using output::Display;
    std::string channels;
    for (const std::string& channel : output::channels_of(variable))
        channels += (channels.empty() ? " `" : ", `") + channel + "`";
    const char* const picture = variable.display == Display::exposed       ? " exposed"
                                : variable.display == Display::share       ? " black to white"
                                : variable.display == Display::leaks       ? " red: leaks, blue: kept out"
                                : variable.display == Display::false_color ? " false colours"
                                : variable.display == Display::count       ? " false colours"
                                : variable.display == Display::count       ? " false colours"
                                                                           : "";
    return std::string("| `") + variable.name + "` |" + channels + " |" + picture + " | "
           + (variable.unit ? variable.unit : "the film's") + " | " + variable.what + " |\n";
}

const Test readme("unit.cli.views.readme_has_the_table", [] {
    std::string text = read_text(STERADIAN_SOURCE "/src/output/README.md");
    text = text.substr(text.find("\n## Output variables"));
    text = text.substr(0, text.find("\n## ", 1));
    std::size_t rows = 0;
    for (std::size_t at = text.find("\n| `"); at != std::string::npos; at = text.find("\n| `", at + 1))
        ++rows;
    for (const output::Variable& variable : output::all_variables())
        EXPECT_NE(text.find(readme_row(variable)), std::string::npos) << readme_row(variable);
    EXPECT_EQ(rows, output::all_variables().size()) << "a row of each variable";
});

} // namespace
