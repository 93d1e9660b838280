#include "scene/prepare.hpp"

#include "core/error.hpp"
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
        return prepare_scene(with_cameras(), "f", {wanted}).camera.name;
    };
    EXPECT_EQ(chosen(""), "front");
    EXPECT_EQ(chosen("side"), "side");
    EXPECT_EQ(chosen("1"), "side");
    EXPECT_EQ(chosen("auto"), "auto");
    EXPECT_EQ(prepare_scene(Scene{}, "f", {}).camera.name, "auto");
    try {
        chosen("2");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "f: no camera '2': choose one of 0 'front', 1 'side', auto, or a view: "
                                   "eye=X,Y,Z;target=X,Y,Z");
    }
});

/// A white square of 1 m in the plane z = 0 that faces the camera "auto".
Scene square() {
    Scene scene;
    scene.materials.push_back({});
    Mesh quad;
    quad.positions = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
    quad.normals.assign(4, vec3(0, 0, 1));
    quad.indices = {0, 1, 2, 0, 2, 3};
    scene.meshes.push_back(quad);
    scene.instances.push_back({0, mat4(1.0f), "square"});
    return scene;
}

/// The square, lit by one light.
RenderScene lit_by(const Light& light, Rig rig = Rig::automatic) {
    Scene scene = square();
    scene.lights.push_back(light);
    return prepare_scene(std::move(scene), "f", {"auto", rig});
}

const Test rig("unit.scene.stage.a_scene_without_light_gets_the_studio_and_says_so", [] {
    const RenderScene lit = prepare_scene(square(), "f", {});
    ASSERT_EQ(lit.lights.size(), 1u);
    ASSERT_TRUE(std::holds_alternative<EnvironmentLight>(lit.lights[0]));
    EXPECT_FALSE(std::get<EnvironmentLight>(lit.lights[0]).is_visible);
    EXPECT_EQ(lit.remarks.size(), 1u);
    EXPECT_EQ(lit.rig, Rig::studio);
    const RenderScene dark = prepare_scene(square(), "f", {"", Rig::none});
    EXPECT_TRUE(dark.lights.empty());
    EXPECT_EQ(dark.remarks.size(), 1u) << "that almost nothing is lit";
    const RenderScene softboxes = prepare_scene(square(), "f", {"", Rig::softboxes});
    EXPECT_EQ(softboxes.lights.size(), 3u);
    EXPECT_EQ(softboxes.scene.instances.size(), 1u) << "softboxes are not seen";
    Scene unlit = square();
    unlit.materials[0].is_unlit = true;
    EXPECT_TRUE(prepare_scene(unlit, "f", {}).lights.empty()) << "it needs no light";
});

const Test arriving("unit.scene.stage.the_studio_comes_where_the_scenes_own_light_does_not_arrive", [] {
    const PointLight in_front{"", {0, 0, 2}}, behind{"", {0, 0, -2}};
    EXPECT_EQ(lit_by(in_front).lights.size(), 1u);
    EXPECT_TRUE(lit_by(in_front).remarks.empty());
    EXPECT_EQ(lit_by(in_front, Rig::studio).lights.size(), 2u) << "it comes where it is asked for";
    EXPECT_EQ(lit_by(behind).lights.size(), 2u);
    EXPECT_EQ(lit_by(behind).remarks.size(), 1u);
    EXPECT_EQ(lit_by(DirectionalLight{"", {0, 0, -1}}).lights.size(), 1u);
    EXPECT_EQ(lit_by(DirectionalLight{"", {0, 0, 1}}).lights.size(), 2u);
    PointLight weak = in_front;
    weak.I = vec3(1e-6f);
    EXPECT_EQ(lit_by(weak).lights.size(), 1u) << "exposure shows what all of the picture gets";
    SpotLight beside{"", {0, 0, 2}};
    beside.direction = vec3(1, 0, 0);
    EXPECT_EQ(lit_by(beside).lights.size(), 2u) << "out of its cone";
});

// A headlight: it glows at the edge of the body and shines away from it.
const Test headlight("unit.scene.stage.a_glowing_detail_is_no_lamp", [] {
    Scene scene = square();
    Material glow;
    glow.emission = vec3(1.0f);
    scene.materials.push_back(glow);
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].material = 1;
    mat4 small(0.05f);
    small[3] = vec4(0.4f, 0.0f, 0.001f, 1.0f);
    scene.instances.push_back({1, small, "headlight"});
    const RenderScene stage = prepare_scene(scene, "f", {});
    EXPECT_EQ(stage.rig, Rig::studio);
    EXPECT_EQ(stage.lights.size(), 2u);
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
    PrepareOptions options;
    options.rig = Rig::none;
    const RenderScene seen = prepare_scene(scene, "f", options);
    options.hide_emitters = true;
    const RenderScene unseen = prepare_scene(scene, "f", options);
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
