#include "shadow/occlusion.hpp"

#include "support/address.hpp"

#include <cmath>

using namespace sr;
using namespace sr::shadow;
using sr::testing::Test;

namespace {

/// A floor, triangle 0, and `sheets` triangles above it at heights 1, 2, 3, …, of a material.
scene::Scene sheets(int count, const scene::Material& material) {
    scene::Scene scene;
    scene.materials = {scene::Material{}, material};
    for (int i = 0; i <= count; ++i) {
        scene::Mesh mesh;
        const auto y = static_cast<float>(i);
        mesh.positions = {{-1.0f, y, -1.0f}, {-1.0f, y, 5.0f}, {5.0f, y, -1.0f}};
        mesh.normals.assign(3, vec3(0.0f, 1.0f, 0.0f));
        mesh.indices = {0, 1, 2};
        mesh.material = i == 0 ? 0 : 1;
        scene.meshes.push_back(mesh);
        scene.instances.push_back({i, mat4(1.0f), ""});
    }
    return scene;
}

float V_towards(const scene::Scene& scene, std::span<const scene::Light> lights, vec3 to_emitter,
                bool is_infinite, int light = 0) {
    const Casters casters = collect_casters(scene, lights);
    const Occlusion occlusion(casters);
    const std::vector<Query> queries(
        11, Query{vec3(0.0f), 0, to_emitter, is_infinite, light}); // a packet and a half
    std::vector<vec3> V(queries.size());
    occlusion.answer(queries, V);
    for (const vec3 value : V) EXPECT_EQ(value, vec3(V.front().x)) << "without glass V has no colour";
    return V.front().x;
}

scene::Material of_alpha(scene::AlphaMode mode, float alpha) {
    scene::Material material;
    material.alpha_mode = mode;
    material.base_color.w = alpha;
    return material;
}

const Test products("unit.shadow.occlusion.multiplies_what_sheets_let_through", [] {
    const vec3 up(0.0f, 1.0f, 0.0f);
    const auto V = [&](scene::AlphaMode mode, float alpha) {
        return V_towards(sheets(3, of_alpha(mode, alpha)), {}, up, true);
    };
    EXPECT_EQ(V(scene::AlphaMode::opaque, 0.0f), 0.0f);
    EXPECT_EQ(V(scene::AlphaMode::blend, 0.25f), 0.75f * 0.75f * 0.75f);
    EXPECT_EQ(V(scene::AlphaMode::blend, 1.0f), 0.0f);
    EXPECT_EQ(V(scene::AlphaMode::mask, 0.4f), 1.0f);
    EXPECT_EQ(V(scene::AlphaMode::mask, 0.6f), 0.0f);
});

const Test ends("unit.shadow.occlusion.rays_end_at_the_emitter", [] {
    const auto scene = sheets(1, scene::Material{});
    EXPECT_EQ(V_towards(scene, {}, {0.0f, 0.9f, 0.0f}, false), 1.0f);
    EXPECT_EQ(V_towards(scene, {}, {0.0f, 1.1f, 0.0f}, false), 0.0f);
    EXPECT_EQ(V_towards(scene, {}, {0.0f, 1.0f, 0.0f}, false), 1.0f)
        << "an emitter in the plane of the sheet";
    EXPECT_EQ(V_towards(scene, {}, {0.0f, -1.0f, 0.0f}, true), 1.0f) << "below the floor";
});

const Test own("unit.shadow.occlusion.emitters_are_ignored_by_their_own_rays", [] {
    auto scene = sheets(2, scene::Material{});
    const std::vector<scene::Light> lights{scene::RectangleLight{}, scene::MeshLight{}};
    scene.instances[1].emits_as = {0, 1};
    scene.instances[2].emits_as = {1, 2};
    EXPECT_EQ(V_towards(scene, lights, {0.0f, 1.5f, 0.0f}, false, 0), 1.0f)
        << "one flat emitter: wherever it is met";
    EXPECT_EQ(V_towards(scene, lights, {0.0f, 1.5f, 0.0f}, false, 1), 0.0f) << "it stands before the mesh";
    scene.instances[1].emits_as = {1, 2};
    EXPECT_EQ(V_towards(scene, lights, {0.0f, 2.0f, 0.0f}, false, 1), 0.0f)
        << "a mesh hides a part of itself";
    EXPECT_EQ(V_towards(scene, lights, {0.0f, 1.0005f, 0.0f}, false, 1), 1.0f) << "but not at the ray's end";
});

const Test huge("unit.shadow.occlusion.coordinates_that_overflow_do_no_harm", [] {
    auto scene = sheets(1, scene::Material{});
    for (const float far : {1e18f, 1e30f, 3e38f, INFINITY, std::nanf("")}) {
        scene.meshes[1].positions[2] = vec3(far);
        const float V = V_towards(scene, {}, {0.0f, 1.0f, 0.0f}, true);
        EXPECT_TRUE(V == 0.0f || V == 1.0f) << far;
    }
});

} // namespace
