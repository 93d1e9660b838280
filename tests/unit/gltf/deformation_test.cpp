// Skins and morph targets: where vertices, normals and tangents go.
#include "loading.hpp"

#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

constexpr float s = 0.70710678f;

/// A strip along y from 0 to 2 in the xy plane, facing +z. Its lower half follows joint 0, which stands at
/// the origin, its upper end joint 1, which stands at y = 1; the vertices at y = 1 follow both.
MadeGltf bar() {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["POSITION"] =
        made.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0}, "VEC3");
    made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    made.attributes()["JOINTS_0"] =
        made.shorts({0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, "VEC4");
    made.attributes()["WEIGHTS_0"] = made.accessor<std::uint8_t>(
        {255, 0, 0, 0, 255, 0, 0, 0, 85, 85, 0, 0, 85, 85, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0}, "VEC4", 5121);
    made.root["accessors"].back()["normalized"] = true;
    made.primitive()["indices"] = made.shorts({0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4});
    std::vector<float> matrices(32, 0.0f);
    for (const std::size_t diagonal : {0, 5, 10, 15}) matrices[diagonal] = matrices[16 + diagonal] = 1.0f;
    matrices[16 + 13] = -1.0f; // from y = 1 down to the joint's origin
    made.root["skins"] =
        json::array({{{"joints", {1, 2}}, {"inverseBindMatrices", made.accessor(matrices, "MAT4", 5126)}}});
    made.root["nodes"] = json::parse(R"([{"mesh": 0, "skin": 0, "translation": [50, 60, 70]},
        {"name": "root", "children": [2]}, {"name": "bend", "translation": [0, 1, 0]}])");
    made.root["scenes"][0]["nodes"] = {0, 1};
    return made;
}

void expect_near(vec3 a, vec3 b) { EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << ' ' << a.y << ' ' << a.z; }

const Test rest("unit.gltf.skin.at_rest_nothing_moves_and_the_node_does_not_matter", [] {
    const scene::Scene scene = load(bar()).scene;
    EXPECT_EQ(scene.instances.at(0).world_from_object, mat4(1.0f));
    for (const vec3 position : scene.meshes.at(0).positions) EXPECT_EQ(position.z, 0.0f);
    expect_near(scene.meshes[0].positions.at(4), vec3(0, 2, 0));
    EXPECT_EQ(load(bar()).warnings.size(), 0u);
});

// Joint 1 turns a quarter about x: what is above y = 1 comes to lie along +z there, its normal to look down.
const Test bent("unit.gltf.skin.a_bar_bends_at_its_joint", [] {
    MadeGltf made = bar();
    made.root["nodes"][2]["rotation"] = {s, 0, 0, s};
    made.root["nodes"][1]["translation"] = {10, 0, 0}; // and the whole skeleton moves
    const scene::Scene scene = load(made).scene;
    const scene::Mesh& mesh = scene.meshes.at(0);
    const vec3 origin(scene.origin); // the file's world is relative to the scene's origin
    expect_near(origin + mesh.positions.at(0), vec3(10, 0, 0));
    expect_near(origin + mesh.positions.at(2), vec3(10, 1, 0)); // on the axis: both joints leave it there
    expect_near(origin + mesh.positions.at(4), vec3(10, 1, 1));
    expect_near(origin + mesh.positions.at(5), vec3(11, 1, 1));
    expect_near(mesh.normals.at(0), vec3(0, 0, 1));
    expect_near(mesh.normals.at(4), vec3(0, -1, 0));
    expect_near(mesh.normals.at(2), vec3(0, -s, s)); // half and half
    const scene::Bounds bounds = scene::bounds_of(scene);
    expect_near(origin + bounds.min, vec3(10, 0, 0));
    expect_near(origin + bounds.max, vec3(11, 1, 1));
});

// A joint that is stretched along z turns normals the other way than it would turn directions.
const Test stretched("unit.gltf.skin.normals_go_by_the_inverse_transpose", [] {
    MadeGltf made = bar();
    made.attributes()["NORMAL"] = made.floats({0, s, s, 0, s, s, 0, s, s, 0, s, s, 0, s, s, 0, s, s}, "VEC3");
    made.root["nodes"][2]["scale"] = {1, 1, 2};
    expect_near(load(made).scene.meshes.at(0).normals.at(4), glm::normalize(vec3(0, 2, 1)));
});

const Test mirrored("unit.gltf.skin.a_mirrored_skeleton_is_a_mirrored_instance", [] {
    MadeGltf made = bar();
    made.root["nodes"][1]["scale"] = {-1, 1, 1};
    const scene::Scene scene = load(made).scene;
    const mat4& world = scene.instances.at(0).world_from_object;
    EXPECT_LT(glm::determinant(mat3(world)), 0.0f);
    expect_near(vec3(world * vec4(scene.meshes.at(0).positions.at(5), 1)), vec3(-1, 2, 0));
    expect_near(glm::inverseTranspose(mat3(world)) * scene.meshes[0].normals.at(5), vec3(0, 0, 1));
});

const Test shared("unit.gltf.skin.two_nodes_bend_one_mesh_each_its_way", [] {
    MadeGltf made = bar();
    made.root["nodes"].push_back({{"mesh", 0}, {"translation", {5, 0, 0}}}); // without a skin
    made.root["scenes"][0]["nodes"] = {0, 1, 3};
    made.root["nodes"][2]["translation"] = {0, 2, 0};
    const scene::Scene scene = load(made).scene;
    ASSERT_EQ(scene.meshes.size(), 2u);
    expect_near(scene.meshes[0].positions.at(4), vec3(0, 3, 0));
    expect_near(scene.meshes[1].positions.at(4), vec3(0, 2, 0));
    EXPECT_EQ(scene.instances.at(1).world_from_object[3], vec4(5, 0, 0, 1));
});

// glTF 2.0, section 3.7.3.3, forbids it; exporters do it. The joints stand where their own tree puts them.
const Test joints_outside("unit.gltf.skin.joints_outside_the_scene_count", [] {
    MadeGltf inside = bar();
    MadeGltf outside = bar();
    outside.root["scenes"][0]["nodes"] = {0};
    for (MadeGltf* made : {&inside, &outside}) made->root["nodes"][1]["translation"] = {0, 5, 1e7};
    const gltf::Loaded expected = load(inside), loaded = load(outside);
    EXPECT_TRUE(loaded.warnings.empty());
    ASSERT_EQ(loaded.scene.meshes.size(), 1u);
    const auto& positions = loaded.scene.meshes[0].positions;
    ASSERT_EQ(positions.size(), expected.scene.meshes[0].positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v)
        EXPECT_EQ(glm::dvec3(positions[v]) + loaded.scene.origin,
                  glm::dvec3(expected.scene.meshes[0].positions[v]) + expected.scene.origin);
});

const Test bad_skins("unit.gltf.skin.what_is_wrong_is_said", [] {
    MadeGltf made = bar();
    made.root["skins"][0]["joints"] = json::array({1});
    EXPECT_NE(error_of(made).find("a mesh with /skins/0 follows the joint 1, and the skin has 1 joints"),
              std::string::npos);
    made.root["skins"][0]["joints"] = json::array({1, 2, 0});
    EXPECT_NE(error_of(made).find("/skins/0 has 2 inverseBindMatrices for 3 joints"), std::string::npos);
    made.root["skins"][0]["joints"] = json::array({1, 7});
    EXPECT_NE(error_of(made).find("/skins/0/joints/1 must be below 3"), std::string::npos);
    made.root["skins"][0].erase("joints");
    EXPECT_NE(error_of(made).find("\"joints\""), std::string::npos);
    MadeGltf half = bar();
    half.attributes().erase("WEIGHTS_0");
    EXPECT_NE(error_of(half).find("has one of JOINTS_0 and WEIGHTS_0"), std::string::npos);
    MadeGltf none = bar();
    none.attributes().erase("WEIGHTS_0");
    none.attributes().erase("JOINTS_0");
    EXPECT_TRUE(warns_once(load(none), "a node has a skin, and its mesh has no joints and weights"));
});

/// A triangle whose second target is sparse: it lifts vertex 2 by (0, 5, 2) and turns its normal.
MadeGltf morphing() {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    const int first = made.floats({1, 0, 0, 1, 0, 0, 1, 0, 0}, "VEC3");
    const int place = made.accessor<std::uint16_t>({2}, "SCALAR", 5123);
    const int lift = made.floats({0, 5, 2}, "VEC3");
    const int turn = made.floats({0, -1, 0}, "VEC3");
    json& accessors = made.root["accessors"];
    for (const int values : {lift, turn})
        accessors.push_back(
            {{"componentType", 5126},
             {"count", 3},
             {"type", "VEC3"},
             {"sparse",
              {{"count", 1},
               {"indices", {{"bufferView", accessors[place]["bufferView"]}, {"componentType", 5123}}},
               {"values", {{"bufferView", accessors[values]["bufferView"]}}}}}});
    const int last = static_cast<int>(accessors.size()) - 1;
    made.primitive()["targets"] =
        json::array({{{"POSITION", first}}, {{"POSITION", last - 1}, {"NORMAL", last}}});
    return made;
}

const Test weights("unit.gltf.morph.targets_add_up_by_their_weights", [] {
    MadeGltf made = morphing();
    expect_near(load(made).scene.meshes.at(0).positions.at(2), vec3(0, 1, 0));
    made.root["meshes"][0]["weights"] = {2, 0.5};
    const scene::Mesh mesh = load(made).scene.meshes.at(0);
    expect_near(mesh.positions.at(0), vec3(2, 0, 0));
    expect_near(mesh.positions.at(2), vec3(2, 3.5, 1));
    expect_near(mesh.normals.at(0), vec3(0, 0, 1));
    expect_near(mesh.normals.at(2), glm::normalize(vec3(0, -0.5, 1)));
    made.root["nodes"][0]["weights"] = {0, 1}; // goes before the mesh's
    expect_near(load(made).scene.meshes.at(0).positions.at(2), vec3(0, 6, 2));
    EXPECT_EQ(load(made).contents.morph_targets, 2u);
});

const Test flat("unit.gltf.morph.absent_normals_stay_flat", [] {
    MadeGltf made = morphing();
    made.attributes().erase("NORMAL");
    made.root["meshes"][0]["weights"] = {0, 1};
    const gltf::Loaded loaded = load(made);
    for (const vec3 normal : loaded.scene.meshes.at(0).normals)
        expect_near(normal, glm::normalize(vec3(0, -2, 6))); // of (0,0,0) (1,0,0) (0,6,2)
});

const Test moved("unit.gltf.morph.weights_are_animated", [] {
    MadeGltf made = morphing();
    const json sampler{{"input", made.floats({0, 2}, "SCALAR")},
                       {"output", made.floats({0, 0, 1, 1}, "SCALAR")}};
    made.root["animations"] = json::array(
        {{{"samplers", json::array({sampler})},
          {"channels", json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}})}}});
    gltf::LoadOptions options;
    options.at = 1.0;
    expect_near(load(made, options).scene.meshes.at(0).positions.at(2), vec3(0.5, 3.5, 1));
});

const Test single("unit.gltf.morph.the_weight_of_a_single_target_is_animated", [] {
    MadeGltf made = morphing();
    made.primitive()["targets"].erase(1);
    const json sampler{{"input", made.floats({0, 2}, "SCALAR")}, {"output", made.floats({0, 1}, "SCALAR")}};
    made.root["animations"] = json::array(
        {{{"samplers", json::array({sampler})},
          {"channels", json::array({{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}})}}});
    gltf::LoadOptions options;
    options.at = 1.0;
    expect_near(load(made, options).scene.meshes.at(0).positions.at(0), vec3(0.5, 0, 0));
});

const Test short_target("unit.gltf.morph.a_target_needs_every_vertex", [] {
    MadeGltf made = morphing();
    made.primitive()["targets"][0]["POSITION"] = made.floats({1, 0, 0}, "VEC3");
    EXPECT_NE(error_of(made).find("/meshes/0/primitives/0 has 1 of POSITION and 3 of POSITION"),
              std::string::npos);
});

} // namespace
