// Nodes, scenes and cameras.
#include "loading.hpp"

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

MadeGltf with_nodes(const json& nodes, const json& roots) {
    MadeGltf made = MadeGltf::triangle();
    made.root["nodes"] = nodes;
    made.root["scenes"] = json::array({{{"nodes", roots}}});
    return made;
}

const Test transforms("unit.gltf.node.transforms_multiply_down_the_hierarchy", [] {
    const MadeGltf made = with_nodes(json::parse(R"([
        {"translation": [10, 0, 0], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "scale": [2, 2, 2], "children": [1, 2]},
        {"name": "child", "translation": [1, 0, 0], "mesh": 0},
        {"name": "matrix", "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,3,0,1], "mesh": 0}])"),
                                     {0});
    const scene::Scene scene = load(made).scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances[0].name, "child");
    EXPECT_LT(glm::length(scene.instances[0].world_from_object * vec4(0, 0, 0, 1) - vec4(10, 2, 0, 1)),
              1e-6f);
    EXPECT_LT(glm::length(scene.instances[0].world_from_object * vec4(1, 0, 0, 1) - vec4(10, 4, 0, 1)),
              1e-6f);
    EXPECT_LT(glm::length(scene.instances[1].world_from_object * vec4(0, 0, 0, 1) - vec4(4, 0, 0, 1)), 1e-6f);
});

const Test mirror("unit.gltf.node.negative_scale_is_kept", [] {
    const MadeGltf made = with_nodes(json::parse(R"([{"mesh": 0, "scale": [-1, 1, 1]}])"), {0});
    EXPECT_EQ(glm::determinant(mat3(load(made).scene.instances.at(0).world_from_object)), -1.0f);
});

const Test order("unit.gltf.node.instances_are_depth_first", [] {
    const MadeGltf made =
        with_nodes(json::parse(R"([{"name": "a", "mesh": 0, "children": [2, 3]}, {"name": "b", "mesh": 0},
        {"name": "c", "mesh": 0}, {"name": "d", "mesh": 0}])"),
                   {1, 0});
    std::string names;
    for (const scene::Instance& instance : load(made).scene.instances) names += instance.name;
    EXPECT_EQ(names, "bacd");
});

const Test bad_graphs("unit.gltf.node.no_tree_is_an_error", [] {
    EXPECT_NE(error_of(with_nodes(json::parse(R"([{"children": [1]}, {"children": [0]}])"), {0}))
                  .find("is its own ancestor"),
              std::string::npos);
    EXPECT_NE(
        error_of(with_nodes(json::parse(R"([{"children": [0]}])"), {0})).find("/nodes/0 is its own ancestor"),
        std::string::npos);
    EXPECT_NE(error_of(with_nodes(json::parse(R"([{"children": [2]}, {"children": [2]}, {}])"), {0, 1}))
                  .find("/nodes/2 is a child of both /nodes/0 and /nodes/1"),
              std::string::npos);
    EXPECT_NE(error_of(with_nodes(json::parse(R"([{}])"), {0, 0})).find("/nodes/0 is in the scene twice"),
              std::string::npos);
    EXPECT_NE(error_of(with_nodes(json::parse(R"([{"rotation": [0, 0, 0, 0]}])"), {0}))
                  .find("/nodes/0/rotation is zero"),
              std::string::npos);
    EXPECT_NE(
        error_of(
            with_nodes(json::parse(R"([{"scale": [1e30, 1, 1], "children": [1]}, {"scale": [1e30, 1, 1]}])"),
                       {0}))
            .find("/nodes/1 stands beyond the range"),
        std::string::npos);
});

const Test deep_graph("unit.gltf.node.a_chain_of_100000_nodes_loads", [] {
    json nodes = json::array();
    for (int i = 1; i < 100000; ++i) nodes.push_back({{"children", {i}}});
    nodes.push_back({{"mesh", 0}});
    EXPECT_EQ(load(with_nodes(nodes, {0})).scene.instances.size(), 1u);
});

const Test scenes("unit.gltf.node.the_scene_can_be_chosen", [] {
    MadeGltf made = with_nodes(json::parse(R"([{"name": "a", "mesh": 0}, {"name": "b", "mesh": 0}])"), {0});
    made.root["scenes"].push_back({{"nodes", {1}}});
    EXPECT_EQ(load(made).scene.instances.at(0).name, "a");
    EXPECT_EQ(load(made, {.scene = 1}).scene.instances.at(0).name, "b");
    made.root["scene"] = 1;
    EXPECT_EQ(load(made).scene.instances.at(0).name, "b");
    EXPECT_EQ(error_of(made, {.scene = 2}),
              "made.gltf: there is no scene 2, the file has 2: choose one from 0 to 1");
    EXPECT_NE(error_of(made, {.scene = -1}), "");
    made.root.erase("scenes");
    made.root.erase("scene");
    EXPECT_EQ(load(made).scene.instances.size(), 2u);
});

MadeGltf with_camera(const json& camera) {
    MadeGltf made = with_nodes(
        json::parse(
            R"([{"name": "node", "camera": 0, "mesh": 0, "translation": [1, 2, 3], "scale": [2, 3, -4]}])"),
        {0});
    made.root["cameras"] = json::array({camera});
    return made;
}

const Test perspective("unit.gltf.camera.perspective", [] {
    const scene::Scene scene = load(with_camera(json::parse(R"({"type": "perspective", "name": "Key",
        "perspective": {"yfov": 0.5, "znear": 0.25, "zfar": 8, "aspectRatio": 1.5}})")))
                                   .scene;
    const scene::Camera& camera = scene.cameras.at(0);
    EXPECT_EQ(camera.name, "Key");
    EXPECT_EQ(vec3(camera.world_from_camera[3]), vec3(1, 2, 3));
    const mat3 rotation(camera.world_from_camera);
    EXPECT_LT(glm::length(rotation * vec3(0, 0, -1) - vec3(0, 0, 1)),
              1e-6f); // where the mirrored node looks
    EXPECT_NEAR(glm::determinant(rotation), 1.0f, 1e-6f);
    const auto& projection = std::get<scene::Perspective>(camera.projection);
    EXPECT_EQ(projection.yfov, 0.5f);
    EXPECT_EQ(projection.znear, 0.25f);
    EXPECT_EQ(projection.zfar, 8.0f);
    EXPECT_EQ(projection.aspect_ratio, 1.5f);
});

const Test infinite_perspective("unit.gltf.camera.zfar_and_aspect_may_be_absent", [] {
    const scene::Scene scene =
        load(with_camera(
                 json::parse(R"({"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.25}})")))
            .scene;
    const auto& projection = std::get<scene::Perspective>(scene.cameras.at(0).projection);
    EXPECT_EQ(scene.cameras.at(0).name, "node");
    EXPECT_FALSE(projection.zfar);
    EXPECT_FALSE(projection.aspect_ratio);
});

const Test orthographic("unit.gltf.camera.orthographic", [] {
    const scene::Scene scene = load(with_camera(json::parse(R"({"type": "orthographic",
        "orthographic": {"xmag": 3, "ymag": 2, "znear": 0, "zfar": 9}})")))
                                   .scene;
    const auto& projection = std::get<scene::Orthographic>(scene.cameras.at(0).projection);
    EXPECT_EQ(projection.xmag, 3.0f);
    EXPECT_EQ(projection.ymag, 2.0f);
    EXPECT_EQ(projection.znear, 0.0f);
    EXPECT_EQ(projection.zfar, 9.0f);
});

const Test bad_cameras("unit.gltf.camera.bad_projections_cost_the_camera", [] {
    const auto error_with = [](const char* camera) { return loss_of(with_camera(json::parse(camera))); };
    EXPECT_EQ(error_with(R"({"type": "perspective", "perspective": {"yfov": 4, "znear": 1}})"),
              "made.gltf: /cameras/0: yfov is 4: it must be between 0 and pi");
    EXPECT_NE(error_with(R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 0}})").find("znear"),
              std::string::npos);
    EXPECT_NE(error_with(R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 2, "zfar": 1}})")
                  .find("zfar"),
              std::string::npos);
    EXPECT_NE(
        error_with(
            R"({"type": "orthographic", "orthographic": {"xmag": 0, "ymag": 1, "znear": 0, "zfar": 1}})")
            .find("xmag"),
        std::string::npos);
    EXPECT_NE(error_with(R"({"type": "perspective"})").find("/cameras/0 has no perspective"),
              std::string::npos);
    EXPECT_NE(error_with(R"({"type": "fisheye"})").find("must be one of perspective, orthographic"),
              std::string::npos);
});

const Test vanished_camera("unit.gltf.camera.one_at_a_node_that_is_scaled_to_0_is_left_out", [] {
    const json fine = json::parse(R"({"type": "perspective", "perspective": {"yfov": 1, "znear": 1}})");
    for (const json& scale : {json{0, 0, 0}, json{1, 1, 0}, json{1, 0, 1}}) {
        MadeGltf made = with_camera(fine);
        for (json& node : made.root["nodes"])
            if (node.contains("camera")) node["scale"] = scale;
        EXPECT_NE(loss_of(made).find("is scaled to nothing"), std::string::npos);
        EXPECT_TRUE(load(made).scene.cameras.empty());
        // Those that are left keep their numbers.
        made.root["nodes"].push_back({{"camera", 0}, {"name", "other"}});
        if (made.root.contains("scenes"))
            made.root["scenes"][0]["nodes"].push_back(made.root["nodes"].size() - 1);
        const scene::Scene scene = load(made).scene;
        ASSERT_EQ(scene.cameras.size(), 1u);
        EXPECT_EQ(scene.cameras[0].number, 1);
    }
});

} // namespace
