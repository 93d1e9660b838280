#include "shadow/bvh.hpp"

#include "support/address.hpp"

#include <algorithm>
#include <cmath>
#include <random>

using namespace sr;
using namespace sr::shadow;
using sr::testing::Test;

namespace {

/// One instance of triangles given by their corners.
Casters casters_from(const std::vector<vec3>& corners) {
    scene::Scene scene;
    scene.materials.emplace_back();
    scene::Mesh mesh;
    mesh.positions = corners;
    mesh.normals.assign(corners.size(), vec3(0.0f, 1.0f, 0.0f));
    for (std::uint32_t i = 0; i < corners.size(); ++i) mesh.indices.push_back(i);
    scene.meshes.push_back(mesh);
    scene.instances.emplace_back();
    return collect_casters(scene, {});
}

std::vector<vec3> soup(int triangles) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-1.0f, 1.0f), size(-0.1f, 0.1f);
    std::vector<vec3> corners;
    for (int t = 0; t < triangles; ++t) {
        const vec3 center(place(random), place(random), place(random));
        for (int i = 0; i < 3; ++i)
            corners.push_back(center + vec3(size(random), size(random), size(random)));
    }
    return corners;
}

bool contains(const BvhNode& node, vec3 p) {
    return glm::all(glm::lessThanEqual(node.low, p)) && glm::all(glm::greaterThanEqual(node.high, p));
}

// A walk from node to node passes every triangle once, in a box that holds it; skipping leads forward.
const Test complete("unit.shadow.bvh.holds_every_triangle_once", [] {
    const Casters casters = casters_from(soup(1000));
    const Bvh bvh = build_bvh(casters);
    std::vector<int> seen(1000, 0);
    for (std::size_t i = 0; i < bvh.nodes.size(); ++i) {
        const BvhNode& node = bvh.nodes[i];
        ASSERT_GT(node.skip, static_cast<std::int32_t>(i));
        ASSERT_LE(node.skip, static_cast<std::int32_t>(bvh.nodes.size()));
        if (node.leaf == 0) continue;
        ASSERT_EQ(node.skip, static_cast<std::int32_t>(i) + 1);
        for (int t = 0; t < (node.leaf & 7); ++t) {
            const std::uint32_t triangle = bvh.order[static_cast<std::size_t>((node.leaf >> 3) + t)];
            ++seen[triangle];
            for (const vec3 corner : casters.triangle(triangle)) EXPECT_TRUE(contains(node, corner));
        }
    }
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), 1000);
});

const Test broken("unit.shadow.bvh.leaves_out_what_has_no_place", [] {
    std::vector<vec3> corners = soup(10);
    const vec3 p(0.5f), q(0.6f, 0.1f, 0.2f);
    for (const vec3 bad : {vec3(std::nanf("")), vec3(INFINITY), vec3(0.0f, 3e38f, 0.0f)})
        corners.insert(corners.end(), {p, q, bad});
    corners.insert(corners.end(), {p, p, p, p, p, q}); // a point and a line stay, where they do no harm
    EXPECT_EQ(build_bvh(casters_from(corners)).order.size(), 12u);
    EXPECT_EQ(build_bvh(casters_from({p, p, vec3(INFINITY)})).nodes.size(), 1u);
    EXPECT_EQ(build_bvh(casters_from({})).nodes.size(), 1u);
    EXPECT_EQ(build_bvh(casters_from(std::vector<vec3>(3000, p))).order.size(), 1000u) << "all in one place";
});

} // namespace
