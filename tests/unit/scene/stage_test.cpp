#include "scene/stage.hpp"

#include "core/error.hpp"
#include "scene/framing.hpp"
#include "support/address.hpp"

#include <algorithm>
#include <cmath>

using namespace sr;
using namespace sr::scene;
using sr::testing::Test;

namespace {

Scene with_cameras() {
    Scene scene;
    for (const char* name : {"front", "side"}) {
        Camera camera;
        camera.name = name;
        scene.cameras.push_back(camera);
    }
    return scene;
}

const Test cameras("unit.scene.stage.cameras_by_name_index_and_default", [] {
    const auto chosen = [](const char* wanted) {
        return set_stage(with_cameras(), "f", {wanted}).camera.name;
    };
    EXPECT_EQ(chosen(""), "front");
    EXPECT_EQ(chosen("side"), "side");
    EXPECT_EQ(chosen("1"), "side");
    EXPECT_EQ(chosen("auto"), "auto");
    EXPECT_EQ(set_stage(Scene{}, "f", {}).camera.name, "auto");
    try {
        chosen("2");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "f: no camera '2': choose one of 0 'front', 1 'side', auto, or a view: "
                                   "eye=X,Y,Z;target=X,Y,Z");
    }
});

const Test rig("unit.scene.stage.a_dark_scene_gets_softboxes_and_says_so", [] {
    const Stage lit = set_stage(Scene{}, "f", {});
    EXPECT_EQ(lit.lights.size(), 3u);
    EXPECT_EQ(lit.remarks.size(), 1u);
    EXPECT_TRUE(lit.scene.instances.empty()) << "softboxes are not seen";
    EXPECT_TRUE(set_stage(Scene{}, "f", {"", Rig::none}).lights.empty());
    Scene own;
    own.lights.emplace_back(PointLight{});
    EXPECT_EQ(set_stage(own, "f", {}).lights.size(), 1u);
});

// Hidden emitters give the same light and are not seen: no surface for a light, no L_e on an emissive one.
const Test hidden("unit.scene.stage.hidden_emitters_still_light", [] {
    Scene scene;
    scene.lights.emplace_back(SphereLight{});
    scene.materials.push_back({});
    scene.materials[0].emission = vec3(5.0f);
    Mesh quad;
    quad.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    quad.normals.assign(4, vec3(0, 0, 1));
    quad.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(quad);
    scene.instances.push_back({0, mat4(1.0f), "glow"});
    StageOptions options;
    const Stage seen = set_stage(scene, "f", options);
    options.hide_emitters = true;
    const Stage unseen = set_stage(scene, "f", options);
    EXPECT_EQ(seen.lights.size(), 2u);
    EXPECT_EQ(unseen.lights.size(), 2u);
    EXPECT_EQ(seen.scene.instances.size(), 2u);
    EXPECT_EQ(unseen.scene.instances.size(), 1u);
    EXPECT_EQ(seen.scene.materials[0].emission, vec3(5.0f));
    EXPECT_EQ(unseen.scene.materials[0].emission, vec3(0.0f));
});

/// The corners of a box, as a mesh without triangles.
Scene box_of(vec3 center, vec3 half) {
    Scene scene;
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.emplace_back(corner & 1 ? half.x : -half.x, corner & 2 ? half.y : -half.y,
                                    corner & 4 ? half.z : -half.z);
    scene.meshes.push_back(mesh);
    mat4 m(1.0f);
    m[3] = vec4(center, 1.0f);
    scene.instances.push_back({0, m, "box"});
    return scene;
}

// All corners of the box are inside the picture, whatever its shape, and the box touches two opposite
// margins.
const Test framing("unit.scene.framing.the_box_fills_the_picture", [] {
    for (const vec3 half : {vec3(1, 1, 1), vec3(100, 1, 1), vec3(0.001f, 0.003f, 0.001f)}) {
        for (const float aspect : {0.5f, 1.0f, 2.0f}) {
            const Scene box = box_of(vec3(5.0f), half);
            const Camera camera = framing_camera(box, aspect);
            const auto& p = std::get<Perspective>(camera.projection);
            const float tan_y = std::tan(0.5f * p.yfov);
            vec2 low(INFINITY), high(-INFINITY);
            for (const vec3 corner : box.meshes[0].positions) {
                const vec3 c = vec3(glm::inverse(camera.world_from_camera) * vec4(corner + 5.0f, 1.0f));
                EXPECT_GT(-c.z, p.znear);
                EXPECT_LT(-c.z, p.zfar.value_or(INFINITY));
                const vec2 at = vec2(c) / (-c.z * vec2(tan_y * aspect, tan_y));
                low = glm::min(low, at);
                high = glm::max(high, at);
            }
            EXPECT_LT(std::max({-low.x, -low.y, high.x, high.y}), 0.94f);
            const auto touches = [](float a, float b) { return a < -0.9f && b > 0.9f; };
            EXPECT_TRUE(touches(low.x, high.x) || touches(low.y, high.y));
        }
    }
});

} // namespace
