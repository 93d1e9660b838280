// Surfaces under scaled, sheared and mirrored nodes against pictures that Mitsuba made of data of its own
// (tools/truth/nodes.py): nothing of ours transformed its vertices, normals or maps.
#include "image/file.hpp"
#include "render/renderer.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "support/models.hpp"
#include "support/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace {

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

constexpr int size = 16; // pixels an edge of a cell

/// A node's linear part, row by row, and half of what the camera sees [m].
struct Node {
    std::array<vec3, 3> rows;
    float half;
};

const std::array<Node, 5> nodes{{{{vec3(0.01f, 0, 0), vec3(0, 0.01f, 0), vec3(0, 0, 0.01f)}, 0.004f},
                                 {{vec3(3, 0, 0), vec3(0, 0.5f, 0), vec3(0, 0, 4)}, 0.2f},
                                 {{vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)}, 0.4f},
                                 {{vec3(1, 0.5f, 0), vec3(0, 0.8f, 0), vec3(0.3f, 0, 0.5f)}, 0.3f},
                                 {{vec3(-2, 0.4f, 0), vec3(0, 1, 0), vec3(0.2f, -0.1f, 3)}, 0.3f}}};

/// The normal map of nodes.py.
void add_map(scene::Scene& scene) {
    scene::TextureImage image;
    image.width = image.height = 4;
    auto& texels = image.texels.emplace<std::vector<std::uint16_t>>();
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 n = glm::normalize(
                glm::dvec3(0.4 * std::sin(1 + 3 * i + 5 * j), 0.4 * std::cos(2 * i + 7 * j), 1.0));
            for (int axis = 0; axis < 3; ++axis)
                texels.push_back(static_cast<std::uint16_t>(std::lround((0.5 + 0.5 * n[axis]) * 65535.0)));
            texels.push_back(65535);
        }
    scene.images.push_back(image);
    scene.textures.push_back({0, scene::Sampler{}, scene::ColorSpace::linear});
    scene.materials[0].normal_texture.texture = 0;
}

scene::Scene square() {
    scene::Scene scene;
    add_quad(scene, vec3(0.0f), {1, 0, 0}, {0, 1, 0}, lambert({0.5f, 0.4f, 0.3f}));
    scene.meshes[0].texcoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    scene.meshes[0].tangents.assign(4, vec4(1, 0, 0, 1));
    add_map(scene);
    return scene;
}

/// The half of a ball that faces +Z, over a square within.
scene::Scene ball() {
    constexpr std::uint32_t cells = 64;
    scene::Scene scene;
    scene.materials.push_back(lambert({0.5f, 0.4f, 0.3f}));
    scene::Mesh mesh;
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const vec2 at = 0.68f * (2.0f * vec2(i, j) / static_cast<float>(cells) - 1.0f);
            mesh.positions.emplace_back(at, std::sqrt(1.0f - glm::dot(at, at)));
        }
    mesh.normals = mesh.positions;
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i, d = a + cells + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, d + 1, a, d + 1, d});
        }
    scene.meshes.push_back(mesh);
    scene.instances.push_back({0, mat4(1.0f), "ball"});
    return scene;
}

image::Image picture_under(const Node& node, scene::Scene scene, bool is_flat) {
    const mat4 placed = mat4(glm::transpose(mat3(node.rows[0], node.rows[1], node.rows[2])));
    scene.instances[0].world_from_object = placed;
    const float height = is_flat ? 0.0f : placed[2][2];
    const std::vector<scene::Light> lamp{
        scene::PointLight{"", vec3(0.5f, 0.7f, 3.0f) * node.half + vec3(0, 0, height),
                          vec3(20.0f, 16.0f, 10.0f) * node.half * node.half}};
    scene::Camera camera;
    camera.world_from_camera[3] = vec4(0, 0, 40.0f * node.half + 40.0f, 1);
    camera.projection = scene::Orthographic{node.half, node.half, 0.0f, 100.0f};
    constexpr int samples = 64;
    return picture(scene, lamp, camera, size, samples, 0, render::Visibility::none);
}

void expect_cells(const scene::Scene& scene, bool is_flat) {
    const image::Image atlas = image::read(source_folder() / "tests/truth/references/nodes.exr");
    ASSERT_EQ(atlas.channels, 6);
    ASSERT_EQ(atlas.width, 2 * static_cast<int>(nodes.size()) * size);
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const image::Image ours = picture_under(nodes[n], scene, is_flat);
        const int first = static_cast<int>(n + (is_flat ? 0 : nodes.size())) * size;
        double sums[2]{}, largest = 0.0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (std::size_t c = 0; c < 3; ++c) {
                    const double a = ours.at(x, y)[c], b = atlas.at(first + x, y)[c];
                    sums[0] += a, sums[1] += b;
                    largest = std::max(largest, std::abs(a - b));
                }
        const double mean = sums[1] / (3.0 * size * size);
        fmt::print("node {}: energy {:.4f} %, largest difference {:.3f} % of the mean\n", n,
                   100.0 * (sums[0] / sums[1] - 1.0), 100.0 * largest / mean);
        EXPECT_NEAR(sums[0] / sums[1], 1.0, 0.0005) << "node " << n;
        // Both programs place their samples within a pixel by chance.
        EXPECT_LT(largest, 0.01 * mean) << "node " << n;
    }
}

const Test mapped("truth.nodes.normal_map", [] { expect_cells(square(), true); });
const Test smooth("truth.nodes.smooth_normals", [] { expect_cells(ball(), false); });

} // namespace
