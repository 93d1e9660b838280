// EXT_mesh_gpu_instancing, KHR_materials_variants, KHR_node_visibility, EXT_texture_webp.
#include "gltf/extensions.hpp"
#include "loading.hpp"

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

const Test instances("unit.gltf.instancing.a_node_draws_its_mesh_many_times", [] {
    MadeGltf made = MadeGltf::triangle();
    const int translation = made.floats({1, 0, 0, 0, 2, 0}, "VEC3");
    const int scale = made.floats({1, 1, 1, 3, 3, 3}, "VEC3");
    json& node = made.root["nodes"][0];
    node["translation"] = {0, 0, 10};
    node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", translation},
                                                                   {"SCALE", scale}};
    const scene::Scene scene = load(made).scene;
    ASSERT_EQ(scene.instances.size(), 2u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances[0].world_from_object[3], vec4(1, 0, 10, 1));
    EXPECT_EQ(scene.instances[1].world_from_object * vec4(1, 0, 0, 1), vec4(3, 2, 10, 1));
    node["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["SCALE"] = made.floats({1, 1, 1}, "VEC3");
    EXPECT_NE(error_of(made).find("EXT_mesh_gpu_instancing/attributes are 2 and 1, which differ in number"),
              std::string::npos);
});

const Test variants("unit.gltf.variants.choose_the_materials", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["materials"] = json::parse(R"([{"name": "plain"}, {"name": "red"}, {"name": "blue"}])");
    made.root["extensions"]["KHR_materials_variants"]["variants"] =
        json::parse(R"([{"name": "a"}, {"name": "b"}])");
    made.primitive()["material"] = 0;
    made.primitive()["extensions"]["KHR_materials_variants"]["mappings"] =
        json::parse(R"([{"material": 1, "variants": [0]}])");
    const auto name = [&](const std::string& variant) {
        gltf::LoadOptions options;
        options.variant = variant;
        return load(made, options).scene.materials.at(0).name;
    };
    EXPECT_EQ(name(""), "plain");
    EXPECT_EQ(name("a"), "red");
    EXPECT_EQ(name("b"), "plain"); // which the primitive does not map
    gltf::LoadOptions unknown;
    unknown.variant = "c";
    EXPECT_NE(error_of(made, unknown).find(R"(there is no material variant "c": choose one of "a", "b")"),
              std::string::npos);
    EXPECT_EQ(load(made).contents.variants, (std::vector<std::string>{"a", "b"}));
});

const Test webp("unit.gltf.texture.a_webp_goes_before_what_stands_beside_it", [] {
    if (!gltf::is_supported("EXT_texture_webp")) GTEST_SKIP() << "built without libwebp";
    MadeGltf made = MadeGltf::triangle();
    made.root["images"] =
        json::array({{{"name", "beside"}, {"uri", png_uri()}}, {{"name", "webp"}, {"uri", png_uri()}}});
    made.root["textures"] =
        json::parse(R"([{"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}}])");
    made.root["materials"] = json::parse(R"([{"emissiveTexture": {"index": 0}}])");
    made.primitive()["material"] = 0;
    EXPECT_EQ(load(made).scene.images.at(0).name, "webp");
    made.root["textures"][0]["extensions"]["EXT_texture_webp"]["source"] = 2;
    EXPECT_NE(loss_of(made).find("/textures/0 has image 2, and there are 2"), std::string::npos);
});

const Test visibility("unit.gltf.visibility.goes_down_the_tree_and_spares_cameras", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root.update(json::parse(R"({
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}},
        "nodes": [{"children": [1, 2], "extensions": {"KHR_node_visibility": {"visible": false}}},
            {"mesh": 0, "extensions": {"KHR_node_visibility": {"visible": true}}},
            {"camera": 0, "extensions": {"KHR_lights_punctual": {"light": 0}}}, {"mesh": 0, "name": "seen"}],
        "scenes": [{"nodes": [0, 3]}]})"));
    const scene::Scene scene = load(made).scene;
    ASSERT_EQ(scene.instances.size(), 1u);
    EXPECT_EQ(scene.instances[0].name, "seen");
    EXPECT_TRUE(scene.lights.empty());
    EXPECT_EQ(scene.cameras.size(), 1u);
});

} // namespace
