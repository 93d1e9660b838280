// Materials of glTF's extensions, read from glTF, against pictures that Mitsuba made of data of its own
// (tools/truth/extensions.py): specular-glossiness, glass, and sheets that scatter light to their other side.
#include "gltf/asset.hpp"
#include "image/file.hpp"
#include "render/renderer.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/made_gltf.hpp"
#include "support/models.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

constexpr int size = 16;    // pixels an edge of a cell
constexpr int enlarged = 4; // so many of ours an edge of one

/// A square of `half` in z = 0, its front towards +Z, (0, 0) of its texture the upper left.
MadeGltf square(float half) {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["POSITION"] =
        made.floats({-half, -half, 0, half, -half, 0, half, half, 0, -half, half, 0}, "VEC3");
    made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    made.attributes()["TEXCOORD_0"] = made.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    made.primitive()["indices"] = made.shorts({0, 1, 2, 0, 2, 3});
    made.primitive()["material"] = 0;
    return made;
}

/// The square with this material; of glass before a wall.
MadeGltf with_material(const char* material, bool is_pane) {
    MadeGltf made = square(is_pane ? 2.0f : 1.0f);
    made.root["materials"] = json::array({json::parse(material)});
    if (!is_pane) return made;
    made.root["meshes"].push_back(made.root["meshes"][0]);
    made.root["meshes"][1]["primitives"][0]["material"] = 1;
    made.root["materials"].push_back(json::parse(
        R"({"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.7, 0.6, 1], "metallicFactor": 0},
            "extensions": {"KHR_materials_specular": {"specularFactor": 0}}})"));
    const float half_angle = 0.5f * glm::radians(20.0f);
    made.root["nodes"] = json::array({{{"mesh", 0},
                                       {"translation", {0, 0, 0.4}},
                                       {"rotation", {std::sin(half_angle), 0, 0, std::cos(half_angle)}}},
                                      {{"mesh", 1}}});
    made.root.erase("scenes");
    made.root.erase("scene");
    return made;
}

/// The two textures of extensions.py, of 4×4 texels.
void add_textures(scene::Scene& scene) {
    std::vector<std::uint8_t> diffuse, specular;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            for (const int code : {60 + 50 * i, 40 + 60 * j, 200 - 30 * i - 10 * j, 255})
                diffuse.push_back(static_cast<std::uint8_t>(code));
            for (const int code : {80 + 20 * i + 10 * j, 100 + 30 * j, 120, 60 + 40 * i + 10 * j})
                specular.push_back(static_cast<std::uint8_t>(code));
        }
    scene.images = {{"diffuse", 4, 4, diffuse}, {"specular", 4, 4, specular}};
}

struct Cell {
    const char* name;
    bool is_pane;
    const char* material;
};

constexpr std::array<Cell, 9> cells{
    {{"plastic", false,
      R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.6, 0.3, 0.1, 1],
        "specularFactor": [0.04, 0.04, 0.04], "glossinessFactor": 0.5}}})"},
     {"metal", false,
      R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0, 0, 0, 1],
        "specularFactor": [1, 0.8, 0.3], "glossinessFactor": 0.6}}})"},
     {"between", false,
      R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.5, 0.6, 0.7, 1],
        "specularFactor": [0.5, 0.25, 0.1], "glossinessFactor": 0.3}}})"},
     {"textured", false,
      R"({"extensions": {"KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [0.9, 0.8, 1, 1],
        "specularFactor": [0.8, 1, 0.6], "glossinessFactor": 0.9, "diffuseTexture": {"index": 0},
        "specularGlossinessTexture": {"index": 1}}}})"},
     {"clear", true, R"({"pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.5, 0.2, 1], "metallicFactor": 0,
        "roughnessFactor": 0.4}, "extensions": {"KHR_materials_transmission": {"transmissionFactor": 1}}})"},
     {"frosted", true,
      R"({"pbrMetallicRoughness": {"baseColorFactor": [0.7, 0.8, 0.9, 1], "metallicFactor": 0,
        "roughnessFactor": 0.5}, "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.6},
        "KHR_materials_ior": {"ior": 1.8}}})"},
     {"volume", true, R"({"pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.4}, "extensions":
        {"KHR_materials_transmission": {"transmissionFactor": 1}, "KHR_materials_volume": {"thicknessFactor": 0.1,
        "attenuationDistance": 0.2, "attenuationColor": [0.8, 0.4, 0.9]}}})"},
     {"leaf", false, R"({"pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.5, 0.1, 1], "metallicFactor": 0,
        "roughnessFactor": 0.6}, "extensions": {"KHR_materials_diffuse_transmission":
        {"diffuseTransmissionFactor": 0.6, "diffuseTransmissionColorFactor": [0.6, 0.8, 0.2]}}})"},
     {"paper", false, R"({"pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.8, 0.7, 1], "metallicFactor": 0,
        "roughnessFactor": 0.4}, "extensions": {"KHR_materials_diffuse_transmission":
        {"diffuseTransmissionFactor": 0.9, "diffuseTransmissionColorFactor": [0.9, 0.8, 0.7]},
        "KHR_materials_transmission": {"transmissionFactor": 0.3}}})"}}};

scene::Scene scene_of(const Cell& cell) {
    MadeGltf made = with_material(cell.material, cell.is_pane);
    const bool is_textured = std::string_view(cell.name) == "textured";
    if (is_textured) {
        made.root["images"] = json::array({{{"uri", png_uri()}}, {{"uri", png_uri()}}});
        made.root["samplers"] = json::array({{{"wrapS", 33071}, {"wrapT", 33071}, {"minFilter", 9729}}});
        made.root["textures"] =
            json::array({{{"source", 0}, {"sampler", 0}}, {{"source", 1}, {"sampler", 0}}});
    }
    const auto file = scratch_folder("truth_extensions") / "made.gltf";
    write_text(file, made.gltf());
    gltf::Loaded loaded = gltf::load(file);
    EXPECT_TRUE(loaded.warnings.empty()) << ::testing::PrintToString(loaded.warnings);
    if (is_textured) add_textures(loaded.scene);
    return std::move(loaded.scene);
}

/// The picture of a cell, each pixel the mean of enlarged² of ours.
image::Image picture_of(const Cell& cell, render::Visibility visibility) {
    const std::vector<scene::Light> lamps{
        scene::RectangleLight{"", {0.4f, -0.6f, 1.5f}, {0.3f, 0, 0}, {0, -0.3f, 0}, {10, 8, 6}},
        scene::RectangleLight{"", {-0.3f, 0.7f, -1.2f}, {0.4f, 0, 0}, {0, 0.4f, 0}, {4, 6, 8}}};
    scene::Camera camera;
    const vec3 eye = 10.0f * vec3(0.3f, 0.5f, 1.0f);
    camera.world_from_camera = glm::inverse(glm::lookAt(eye, vec3(0.0f), vec3(0, 1, 0)));
    camera.projection = scene::Orthographic{0.4f, 0.4f, 0.1f, 100.0f};
    constexpr int samples = 64;
    const image::Image large =
        picture(scene_of(cell), lamps, camera, enlarged * size, samples, 0, visibility);
    image::Image mean(size, size, 3);
    for (int y = 0; y < enlarged * size; ++y)
        for (int x = 0; x < enlarged * size; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                mean.at(x / enlarged, y / enlarged)[c] += large.at(x, y)[c] / (enlarged * enlarged);
    return mean;
}

void expect_as_stored(std::size_t number, render::Visibility visibility) {
    const Cell& cell = cells[number];
    const image::Image atlas = image::read(source_folder() / "tests/truth/references/extensions.exr");
    ASSERT_EQ(atlas.channels, 6);
    ASSERT_EQ(atlas.width, static_cast<int>(cells.size()) * size);
    const image::Image ours = picture_of(cell, visibility);
    std::array<double, 3> sums{}, stored{};
    double largest = 0.0, farthest = 0.0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                const auto reference = atlas.at(static_cast<int>(number) * size + x, y);
                const double a = ours.at(x, y)[c], b = reference[c], sigma = reference[c + 3];
                sums[c] += a, stored[c] += b;
                largest = std::max(largest, std::abs(a - b) / b);
                farthest = std::max(farthest, std::abs(a - b) / (sigma + 0.002 * b));
            }
    double energy = 0.0;
    for (std::size_t c = 0; c < 3; ++c) energy = std::max(energy, std::abs(sums[c] / stored[c] - 1.0));
    fmt::print("{}: energy {:.3f} %, largest difference {:.2f} %, {:.1f} σ\n", cell.name, 100.0 * energy,
               100.0 * largest, farthest);
    EXPECT_LT(energy, 0.003) << cell.name; // of it up to 0.06 % are Mitsuba's noise
    EXPECT_LT(farthest, 5.0) << cell.name; // σ: Mitsuba's noise at the pixel, and 0.2 % of ours
}

const Test spec_gloss("truth.extensions.specular_glossiness", [] {
    for (std::size_t cell = 0; cell < 4; ++cell) expect_as_stored(cell, render::Visibility::ray_on_cpu);
});
const Test transmission("truth.extensions.transmission", [] {
    for (std::size_t cell = 4; cell < 7; ++cell) expect_as_stored(cell, render::Visibility::ray_on_cpu);
    expect_as_stored(4, render::Visibility::ray_in_glsl);
});
const Test diffuse_transmission("truth.extensions.diffuse_transmission", [] {
    for (std::size_t cell = 7; cell < 9; ++cell) expect_as_stored(cell, render::Visibility::ray_on_cpu);
});

} // namespace
