#include "gltf/read/mikktspace.hpp"

#include "mikktspace_reference.hpp"
#include "support/address.hpp"

#include <cmath>
#include <iterator>
#include <numeric>

using namespace sr;
using sr::testing::Test;

namespace {

struct Triangles {
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec2> texcoords;
    std::vector<std::uint32_t> indices;

    std::vector<vec4> tangents() const { return gltf::mikktspace(positions, normals, texcoords, indices); }
};

// Coordinates in 1/256, so that they do not depend on the last bit of a cosine.
double rounded(double x) { return std::round(x * 256.0) / 256.0; }

// A torus of 6 x 3 quads, each triangle with vertices of its own. u runs forth and back again (mirrored
// halves), v has a seam.
Triangles torus() {
    constexpr int major = 6;
    constexpr int minor = 3;
    Triangles mesh;
    const auto add = [&](int i, int j) {
        const double a = 2.0 * 3.14159265358979323846 * i / major;
        const double b = 2.0 * 3.14159265358979323846 * j / minor;
        const glm::dvec3 n(rounded(std::cos(a) * std::cos(b)), rounded(std::sin(b)),
                           rounded(std::sin(a) * std::cos(b)));
        mesh.positions.emplace_back(rounded(std::cos(a) * (2.0 + std::cos(b))), rounded(std::sin(b)),
                                    rounded(std::sin(a) * (2.0 + std::cos(b))));
        mesh.normals.emplace_back(n / std::sqrt(glm::dot(n, n)));
        mesh.texcoords.emplace_back(double(i <= major / 2 ? i : major - i) / major, double(j) / minor);
    };
    for (int i = 0; i < major; ++i)
        for (int j = 0; j < minor; ++j) {
            add(i, j), add(i, j + 1), add(i + 1, j + 1);
            add(i, j), add(i + 1, j + 1), add(i + 1, j);
        }
    mesh.indices.resize(mesh.positions.size());
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
    return mesh;
}

Triangles one_triangle() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
            {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}},
            {{0, 1}, {1, 1}, {0, 0}}, // the picture upright: v goes down
            {0, 1, 2}};
}

const Test reference("unit.gltf.mikktspace.equals_the_reference", [] {
    const std::vector<vec4> tangents = torus().tangents();
    ASSERT_EQ(tangents.size(), std::size(sr::testing::torus_tangents));
    for (std::size_t i = 0; i < tangents.size(); ++i)
        EXPECT_LT(glm::length(tangents[i] - sr::testing::torus_tangents[i]), 2e-6f) << "corner " << i;
});

const Test upright("unit.gltf.mikktspace.bitangent_points_up_the_picture", [] {
    for (const vec4 tangent : one_triangle().tangents()) {
        EXPECT_EQ(tangent, vec4(1, 0, 0, 1));
        EXPECT_EQ(tangent.w * glm::cross(vec3(0, 0, 1), vec3(tangent)), vec3(0, 1, 0));
    }
});

const Test mirrored("unit.gltf.mikktspace.mirrored_texture_turns_w", [] {
    Triangles mesh = one_triangle();
    for (vec2& uv : mesh.texcoords) uv.x = -uv.x;
    for (const vec4 tangent : mesh.tangents()) EXPECT_EQ(tangent, vec4(-1, 0, 0, -1));
});

const Test degenerate("unit.gltf.mikktspace.no_area_gives_a_unit_tangent", [] {
    Triangles flat_texture = one_triangle();
    flat_texture.texcoords.assign(3, vec2(0.5f));
    for (const vec4 tangent : flat_texture.tangents()) EXPECT_EQ(glm::length(vec3(tangent)), 1.0f);
    Triangles point = one_triangle();
    point.positions.assign(3, vec3(1.0f));
    for (const vec4 tangent : point.tangents()) EXPECT_EQ(glm::length(vec3(tangent)), 1.0f);
});

} // namespace
