// Animations: what they move, when, and what is wrong with some.
#include "loading.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

json channel(int sampler, const json& target) { return {{"sampler", sampler}, {"target", target}}; }

json pointer(const std::string& text) {
    return {{"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", text}}}}}};
}

/// Adds an animation of one channel with two keys, at 1 s and 3 s.
void animate(MadeGltf& made, const json& target, const std::vector<float>& values, const std::string& type,
             const std::string& interpolation = "LINEAR") {
    const json sampler{{"input", made.floats({1, 3}, "SCALAR")},
                       {"output", made.floats(values, type)},
                       {"interpolation", interpolation}};
    made.root["animations"].push_back({{"name", "clip " + std::to_string(made.root["animations"].size())},
                                       {"samplers", json::array({sampler})},
                                       {"channels", json::array({channel(0, target)})}});
}

gltf::LoadOptions at(double seconds, const std::string& animation = "") {
    gltf::LoadOptions options;
    options.at = seconds;
    options.animation = animation;
    return options;
}

const Test transforms("unit.gltf.animation.moves_rotates_and_scales", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["nodes"][0]["translation"] = {7, 0, 0};
    animate(made, {{"node", 0}, {"path", "translation"}}, {0, 0, 0, 2, 4, 6}, "VEC3");
    animate(made, {{"node", 0}, {"path", "rotation"}}, {0, 0, 0, 1, 0, 0, 1, 0},
            "VEC4"); // half a turn about z
    animate(made, {{"node", 0}, {"path", "scale"}}, {1, 1, 1, 3, 3, 3}, "VEC3");
    EXPECT_EQ(world_from_object(load(made).scene)[3], vec4(7, 0, 0, 1)); // at rest
    EXPECT_EQ(world_from_object(load(made, at(0.5)).scene)[3], vec4(0, 0, 0, 1));
    EXPECT_EQ(world_from_object(load(made, at(2)).scene)[3], vec4(1, 2, 3, 1));
    const mat4 turned = world_from_object(load(made, at(2, "1")).scene);
    EXPECT_LT(glm::length(turned * vec4(1, 0, 0, 1) - vec4(7, 1, 0, 1)), 1e-6f);
    EXPECT_EQ(load(made, at(3, "clip 2")).scene.instances.at(0).world_from_object[0], vec4(3, 0, 0, 0));
    const mat4 all = world_from_object(load(made, at(3, "all")).scene);
    EXPECT_LT(glm::length(all * vec4(1, 0, 0, 1) - vec4(-1, 4, 6, 1)), 1e-6f);
});

const Test posing("unit.gltf.animation.an_asset_is_posed_again_and_again", [] {
    MadeGltf made = MadeGltf::triangle();
    animate(made, {{"node", 0}, {"path", "translation"}}, {0, 0, 0, 2, 0, 0}, "VEC3");
    animate(made, {{"node", 0}, {"path", "scale"}}, {1, 1, 1, 3, 3, 3}, "VEC3");
    const auto file = test_folder() / "made.gltf";
    write_text(file, made.gltf());
    gltf::Asset asset(file);
    ASSERT_EQ(asset.contents().animations.size(), 2u);
    EXPECT_EQ(asset.contents().animations[1].duration, 3.0);
    scene::Scene scene = asset.rest_pose();
    scene.meshes.emplace_back(); // as a RenderScene adds them
    scene = asset.evaluate(std::move(scene), {{0}, 2.0});
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.instances.at(0).world_from_object[3], vec4(1, 0, 0, 1));
    scene = asset.evaluate(std::move(scene), {{1}, 3.0}); // nothing of the first is left
    EXPECT_EQ(scene.instances.at(0).world_from_object, glm::mat4(mat3(3.0f)));
    scene = asset.evaluate(std::move(scene), {{}, 0.0});
    EXPECT_EQ(scene.instances.at(0).world_from_object, mat4(1.0f));
});

const Test pointers("unit.gltf.animation.pointers_move_materials_lights_cameras_and_visibility", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root.update(json::parse(R"({"extensionsUsed": ["KHR_animation_pointer", "KHR_node_visibility"],
        "materials": [{"extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 1}},
                       "emissiveFactor": [1, 1, 1]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point"}]}}})"));
    made.primitive()["material"] = 0;
    made.root["nodes"][0]["extensions"] = {{"KHR_node_visibility", json::object()}};
    made.root["nodes"].push_back(
        {{"camera", 0},
         {"extensions",
          {{"KHR_lights_punctual", {{"light", 0}}}, {"KHR_node_visibility", {{"visible", false}}}}}});
    made.root["scenes"][0]["nodes"] = {0, 1};
    animate(made, pointer("/materials/0/pbrMetallicRoughness/baseColorFactor"), {0, 0, 0, 1, 1, .5, 0, 1},
            "VEC4");
    animate(made, pointer("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength"), {2, 6},
            "SCALAR");
    animate(made, pointer("/extensions/KHR_lights_punctual/lights/0/intensity"), {2, 6}, "SCALAR");
    animate(made, pointer("/cameras/0/perspective/yfov"), {0.5, 1.5}, "SCALAR");
    animate(made, pointer("/nodes/0/extensions/KHR_node_visibility/visible"), {0, 1}, "SCALAR", "STEP");
    animate(made, pointer("/nodes/1/extensions/KHR_node_visibility/visible"), {1, 1}, "SCALAR", "STEP");
    const scene::Scene rest = load(made).scene;
    EXPECT_TRUE(rest.lights.empty());
    EXPECT_EQ(rest.instances.size(), 1u);
    const scene::Scene all = load(made, at(2, "all")).scene;
    EXPECT_EQ(all.materials.at(0).base_color, vec4(.5f, .25f, 0, 1));
    EXPECT_EQ(all.materials.at(0).emission, vec3(4));
    EXPECT_EQ(std::get<scene::PointLight>(all.lights.at(0)).I, vec3(4));
    EXPECT_EQ(std::get<scene::Perspective>(all.cameras.at(0).projection).yfov, 1.0f);
    EXPECT_TRUE(all.instances.empty());
    EXPECT_EQ(load(made, at(3, "all")).scene.instances.size(), 1u);
});

// The schema says what is a number; what the file leaves out comes and goes with the animation.
const Test absent("unit.gltf.animation.a_property_that_the_file_leaves_out_can_move", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["materials"] = json::parse(R"([{"extensions": {"KHR_materials_sheen": {}}}])");
    made.primitive()["material"] = 0;
    animate(made, pointer("/materials/0/extensions/KHR_materials_sheen/sheenColorFactor"),
            {1, 1, 1, 1, 0.5f, 0}, "VEC3");
    const auto file = test_folder() / "made.gltf";
    write_text(file, made.gltf());
    gltf::Asset asset(file);
    scene::Scene scene = asset.rest_pose();
    EXPECT_EQ(scene.materials.at(0).sheen_color, vec3(0));
    scene = asset.evaluate(std::move(scene), {{0}, 3.0});
    EXPECT_EQ(scene.materials.at(0).sheen_color, vec3(1, 0.5f, 0));
    scene = asset.evaluate(std::move(scene), {{}, 0.0});
    EXPECT_EQ(scene.materials.at(0).sheen_color, vec3(0));
    EXPECT_TRUE(asset.warnings().empty());
    made.root["nodes"][0]["extras"] = json::parse(
        R"({"steradian": {"shape": "sphere", "radius": 1, "quantity": {"value": 1, "unit": "lm"}}})");
    animate(made, pointer("/nodes/0/extras/steradian/radius"), {1, 2}, "SCALAR"); // not of glTF's model
    EXPECT_TRUE(warns_once(load(made), R"(moves "/nodes/0/extras/steradian/radius": that stays as it is)"));
});

const Test beyond("unit.gltf.animation.beyond_its_end_is_one_line", [] {
    MadeGltf made = MadeGltf::triangle();
    EXPECT_NE(error_of(made, at(0)).find("it has no animation"), std::string::npos);
    animate(made, {{"node", 0}, {"path", "scale"}}, {1, 1, 1, 3, 3, 3}, "VEC3");
    EXPECT_EQ(error_of(made, at(3.5)),
              "made.gltf: 3.5 s is beyond its animation, which ends at 3 s: choose a "
              "time from 0 to 3");
    EXPECT_NE(error_of(made, at(1, "Walk")).find(R"(no animation "Walk": choose one of 0 "clip 0", all)"),
              std::string::npos);
});

const Test broken("unit.gltf.animation.what_is_wrong_with_a_sampler_is_said", [] {
    const json target{{"node", 0}, {"path", "scale"}};
    MadeGltf few = MadeGltf::triangle();
    animate(few, target, {1, 1, 1}, "VEC3");
    EXPECT_NE(loss_of(few).find("/animations/0/samplers/0 has 3 numbers in its output, and 2 keys of what it "
                                "moves have 6"),
              std::string::npos);
    MadeGltf backwards = MadeGltf::triangle();
    animate(backwards, target, {1, 1, 1, 1, 1, 1}, "VEC3");
    backwards.root["animations"][0]["samplers"][0]["input"] = backwards.floats({2, 1}, "SCALAR");
    EXPECT_NE(loss_of(backwards).find("/animations/0/samplers/0/input has times that do not increase"),
              std::string::npos);
    MadeGltf missing = MadeGltf::triangle();
    animate(missing, target, {1, 1, 1, 1, 1, 1}, "VEC3");
    missing.root["animations"][0]["channels"][0]["sampler"] = 3;
    EXPECT_NE(loss_of(missing).find("/animations/0/channels/0/sampler is 3, and there are 1"),
              std::string::npos);
    MadeGltf unknown = MadeGltf::triangle();
    animate(unknown, pointer("/materials/0/doubleSided"), {0, 1}, "SCALAR");
    EXPECT_TRUE(warns_once(
        load(unknown), R"(/animations/0/channels/0 moves "/materials/0/doubleSided": that stays as it is)"));
});

const Test no_target("unit.gltf.animation.a_channel_without_a_target_is_ignored", [] {
    MadeGltf made = MadeGltf::triangle();
    animate(made, {{"path", "translation"}}, {0, 0, 0, 2, 4, 6}, "VEC3");
    EXPECT_NE(loss_of(made, at(0.5)).find("/animations/0/channels/0/target names no node"),
              std::string::npos);
    EXPECT_EQ(load(made, at(2)).scene.instances.at(0).world_from_object, mat4(1.0f));
    EXPECT_NE(error_of(made, at(3.5)).find("ends at 3 s"), std::string::npos); // it still has its length
    made.root["animations"][0]["channels"][0]["target"]["node"] = 9;
    EXPECT_NE(loss_of(made, at(0.5)).find("/animations/0/channels/0/target/node must be below 1"),
              std::string::npos);
    made.root["animations"][0]["channels"][0] = "none";
    EXPECT_NE(loss_of(made, at(0.5)).find("/animations/0/channels/0 must be an object"), std::string::npos);
});

// The other channels go on, and a moment that the lost one may have had is no error.
const Test lost_channel("unit.gltf.animation.a_broken_channel_costs_that_channel", [] {
    for (const std::vector<float>& times : {std::vector<float>{2, 1}, {-1, 1}, {0, NAN}, {0, INFINITY}}) {
        MadeGltf made = MadeGltf::triangle();
        animate(made, {{"node", 0}, {"path", "scale"}}, {1, 1, 1, 3, 3, 3}, "VEC3");
        json& animation = made.root["animations"][0];
        animation["samplers"].push_back(animation["samplers"][0]);
        animation["samplers"][1]["input"] = made.floats(times, "SCALAR");
        animation["channels"].push_back(channel(1, {{"node", 0}, {"path", "translation"}}));
        EXPECT_NE(loss_of(made, at(3)).find("/animations/0/samplers/1/input has times"), std::string::npos);
        EXPECT_EQ(load(made, at(3)).scene.instances.at(0).world_from_object, glm::mat4(mat3(3.0f)));
        EXPECT_EQ(load(made, at(30)).scene.instances.at(0).world_from_object, glm::mat4(mat3(3.0f)));
        EXPECT_EQ(load(made, at(3)).contents.animations.at(0).channels, 1u);
    }
});

const Test lost_sampler("unit.gltf.animation.a_sampler_without_accessor_costs_its_channels", [] {
    for (const json& input : {json(17), json("zero"), json(nullptr)}) {
        MadeGltf made = MadeGltf::triangle();
        animate(made, {{"node", 0}, {"path", "scale"}}, {1, 1, 1, 3, 3, 3}, "VEC3");
        made.root["animations"][0]["samplers"][0]["input"] = input;
        EXPECT_NE(loss_of(made, at(1)).find("/animations/0/samplers/0/input must be"), std::string::npos);
        EXPECT_EQ(load(made, at(1)).scene.instances.at(0).world_from_object, mat4(1.0f));
    }
    MadeGltf none = MadeGltf::triangle();
    animate(none, {{"node", 0}, {"path", "scale"}}, {1, 1, 1, 3, 3, 3}, "VEC3");
    none.root["animations"][0].erase("channels");
    EXPECT_NE(loss_of(none, at(1)).find("/animations/0 must have the property \"channels\""),
              std::string::npos);
});

} // namespace
