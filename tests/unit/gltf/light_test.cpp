#include "loading.hpp"

#include <algorithm>
#include <limits>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

// One light on a node at (1, 2, 3) that is turned by 90° about x, so that its -Z is the world's +Y, and
// scaled by 2.
MadeGltf with_light(const std::string& extension, const char* light) {
    MadeGltf made = MadeGltf::triangle();
    made.root["extensions"][extension]["lights"] = json::array({json::parse(light)});
    made.root["nodes"].push_back({{"name", "lamp"},
                                  {"translation", {1, 2, 3}},
                                  {"rotation", {0.7071067811865476, 0, 0, 0.7071067811865476}},
                                  {"scale", {2, 2, 2}},
                                  {"extensions", {{extension, {{"light", 0}}}}}});
    made.root["scenes"][0]["nodes"] = {0, 1};
    return made;
}

MadeGltf punctual(const char* light) { return with_light("KHR_lights_punctual", light); }
MadeGltf area(const char* light) { return with_light("EXT_lights_area", light); }

const Test point("unit.gltf.light.point", [] {
    const auto light = light_of<scene::PointLight>(
        punctual(R"({"type": "point", "name": "Key", "color": [1, 0.5, 0], "intensity": 40, "range": 7})"));
    EXPECT_EQ(light.name, "Key");
    EXPECT_EQ(light.position, vec3(1, 2, 3));
    EXPECT_EQ(light.I, vec3(40, 20, 0));
    EXPECT_EQ(light.range, 7.0f);
});

const Test defaults("unit.gltf.light.defaults", [] {
    const auto light = light_of<scene::PointLight>(punctual(R"({"type": "point"})"));
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.I, vec3(1));
    EXPECT_EQ(light.range, std::numeric_limits<float>::infinity());
    const auto zero = light_of<scene::PointLight>(punctual(R"({"type": "point", "range": 0})"));
    EXPECT_EQ(zero.range, std::numeric_limits<float>::infinity());
    const auto spot = light_of<scene::SpotLight>(punctual(R"({"type": "spot", "spot": {}})"));
    EXPECT_EQ(spot.inner_angle, 0.0f);
    EXPECT_NEAR(spot.outer_angle, pi / 4.0f, 1e-6f);
});

const Test spot("unit.gltf.light.spot", [] {
    const auto light = light_of<scene::SpotLight>(punctual(
        R"({"type": "spot", "intensity": 10, "spot": {"innerConeAngle": 0.25, "outerConeAngle": 0.5}})"));
    EXPECT_LT(glm::length(light.direction - vec3(0, 1, 0)), 1e-6f);
    EXPECT_EQ(light.I, vec3(10));
    EXPECT_EQ(light.inner_angle, 0.25f);
    EXPECT_EQ(light.outer_angle, 0.5f);
});

const Test directional("unit.gltf.light.directional", [] {
    const auto light =
        light_of<scene::DirectionalLight>(punctual(R"({"type": "directional", "intensity": 3})"));
    EXPECT_LT(glm::length(light.direction - vec3(0, 1, 0)), 1e-6f);
    EXPECT_EQ(light.E, vec3(3));
});

const Test bad_lights("unit.gltf.light.bad_ones_are_off_and_named", [] {
    EXPECT_EQ(loss_of(punctual(R"({"type": "point", "name": "Key", "intensity": -1})")),
              "made.gltf: light \"Key\" (/extensions/KHR_lights_punctual/lights/0) has the intensity -1: "
              "give zero or more");
    EXPECT_NE(loss_of(punctual(R"({"type": "point", "color": [1, -1, 1]})")).find("has the colour 1 -1 1"),
              std::string::npos);
    EXPECT_NE(loss_of(punctual(R"({"type": "point", "range": -2})")).find("range"), std::string::npos);
    EXPECT_NE(loss_of(punctual(R"({"type": "laser"})")).find("must be one of point, spot, directional"),
              std::string::npos);
    EXPECT_NE(
        loss_of(punctual(R"({"type": "spot", "spot": {"outerConeAngle": 0}})")).find("outerConeAngle 0"),
        std::string::npos);
    EXPECT_TRUE(load(punctual(R"({"type": "laser"})")).scene.lights.empty());
    EXPECT_EQ(load(punctual(R"({"type": "spot"})")).scene.lights.size(), 1u); // both angles have defaults
});

// Blender writes inner = outer for spot_blend 0.
const Test cones("unit.gltf.light.angles_out_of_order_make_a_hard_edge", [] {
    struct Case {
        const char* angles;
        float inner, outer;
        const char* meaning;
    };
    for (const Case& c :
         {Case{R"({"innerConeAngle": 0.5, "outerConeAngle": 0.5})", 0.5f, 0.5f, "its edge is hard"},
          Case{R"({"innerConeAngle": 0.6, "outerConeAngle": 0.5})", 0.5f, 0.5f, "its edge is hard"},
          Case{R"({"innerConeAngle": -0.1})", 0.0f, pi / 4, "taken for 0 and 0.785398"},
          Case{R"({"innerConeAngle": 0.1, "outerConeAngle": 2})", 0.1f, pi / 2,
               "taken for 0.1 and 1.5708"}}) {
        const MadeGltf made =
            punctual((std::string(R"({"type": "spot", "spot": )") + c.angles + "}").c_str());
        EXPECT_NE(loss_of(made).find("has the cone angles"), std::string::npos);
        const gltf::Loaded loaded = load(made);
        EXPECT_TRUE(warns_once(loaded, c.meaning)) << loaded.warnings.at(0);
        const auto& light = std::get<scene::SpotLight>(loaded.scene.lights.at(0));
        EXPECT_NEAR(light.inner_angle, c.inner, 1e-6f);
        EXPECT_NEAR(light.outer_angle, c.outer, 1e-6f);
    }
});

// Inside the outer angle the intensity is full: the ramp of the falloff is a millionth of a cosine wide.
const Test hard_edge("unit.gltf.light.a_hard_edge_is_full_inside", [] {
    for (const float angle : {0.01f, 0.6f, pi / 2}) {
        scene::SpotLight light;
        light.inner_angle = light.outer_angle = angle;
        const scene::ConeFalloff cone = scene::cone_falloff(light);
        const auto falloff = [&](double theta) {
            return std::clamp(std::cos(theta) * cone.scale + cone.offset, 0.0, 1.0);
        };
        EXPECT_EQ(falloff(angle * 0.98), 1.0) << angle;
        EXPECT_LT(falloff(angle * 1.0001), 0.1) << angle;
    }
});

const Test vanished("unit.gltf.light.a_lamp_at_a_node_that_is_scaled_to_0_is_off", [] {
    for (const char* type : {"point", "spot", "directional"}) {
        MadeGltf made = punctual((std::string(R"({"type": ")") + type + "\"}").c_str());
        made.root["nodes"][1]["scale"] = {0, 0, 0};
        EXPECT_NE(loss_of(made).find("/nodes/1 is scaled to 0"), std::string::npos);
        EXPECT_TRUE(load(made).scene.lights.empty());
        made.root["nodes"][1]["scale"] = {1, 1, 0}; // a point needs no direction
        EXPECT_EQ(load(made).scene.lights.size(), std::string(type) == "point" ? 1u : 0u);
        made.root["nodes"][1]["scale"] = {1, 0, 1};
        EXPECT_EQ(load(made).scene.lights.size(), 1u);
        made.root["nodes"][1].erase("scale"); // and of a node above
        made.root["nodes"].push_back({{"children", {1}}, {"scale", {0, 0, 0}}});
        made.root["scenes"][0]["nodes"] = {0, 2};
        EXPECT_NE(loss_of(made).find("/nodes/1 is scaled to 0"), std::string::npos);
    }
});

const Test bad_reference("unit.gltf.light.a_reference_out_of_range_is_no_lamp", [] {
    MadeGltf made = punctual(R"({"type": "point"})");
    made.root["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 1;
    EXPECT_NE(loss_of(made).find("/nodes/1/extensions/KHR_lights_punctual/light must be below 1"),
              std::string::npos);
    made.root.erase("extensions");
    EXPECT_NE(loss_of(made).find("must be below 0"), std::string::npos);
});

const Test rectangle("unit.gltf.light.rectangle", [] {
    for (const char* key : {"type", "shape"}) {
        const std::string light =
            std::string(R"({")") + key
            + R"(": "rect", "name": "Panel", "color": [1, 1, 0.5], "intensity": 200, "size": 3, "rect": {"aspect": 2}})";
        const auto panel = light_of<scene::RectangleLight>(area(light.c_str()));
        EXPECT_EQ(panel.name, "Panel");
        EXPECT_EQ(panel.center, vec3(1, 2, 3));
        EXPECT_EQ(panel.L, vec3(200, 200, 100));
        EXPECT_NEAR(glm::length(panel.half_u), 6.0f, 1e-5f); // 2 (scale) * 3 (size) * 2 (aspect) / 2
        EXPECT_NEAR(glm::length(panel.half_v), 3.0f, 1e-5f);
        EXPECT_NEAR(std::abs(panel.half_u.x), 6.0f, 1e-5f); // width along the node's X
        EXPECT_LT(glm::length(panel.normal() - vec3(0, 1, 0)), 1e-6f);
        EXPECT_FALSE(panel.is_two_sided);
    }
});

const Test rectangle_defaults("unit.gltf.light.rectangle_defaults", [] {
    const auto panel = light_of<scene::RectangleLight>(area(R"({"type": "rect"})"));
    EXPECT_EQ(panel.name, "lamp");
    EXPECT_EQ(panel.L, vec3(1000));
    EXPECT_NEAR(panel.area(), 4.0f, 1e-5f); // 1 m square, scaled by 2
});

const Test rectangle_mirrored("unit.gltf.light.a_mirrored_rectangle_emits_along_minus_z", [] {
    MadeGltf made = area(R"({"type": "rect"})");
    for (const json& scale : {json{-1, 1, 1}, json{1, 1, -1}, json{-1, 3, -1}}) {
        made.root["nodes"][1]["scale"] = scale;
        const float sign = scale[2].get<float>();
        const auto panel = light_of<scene::RectangleLight>(made);
        EXPECT_LT(glm::length(panel.normal() - vec3(0, sign, 0)), 1e-6f);
        EXPECT_NEAR(glm::dot(panel.half_u, panel.half_v), 0.0f, 1e-6f);
    }
    EXPECT_NEAR(light_of<scene::RectangleLight>(made).area(), 9.0f,
                1e-5f); // one number scales: the largest
});

const Test bad_areas("unit.gltf.light.bad_areas_are_off_and_named", [] {
    for (const char* bad : {R"("size": 0)", R"("size": -1)", R"("rect": {"aspect": 0})"}) {
        const std::string light = std::string(R"({"type": "rect", "name": "Panel", )") + bad + "}";
        EXPECT_NE(loss_of(area(light.c_str()))
                      .find("light \"Panel\" (/extensions/EXT_lights_area/lights/0) has the size"),
                  std::string::npos)
            << bad;
    }
    EXPECT_NE(loss_of(area(R"({"type": "rect", "intensity": -1})")).find("has the intensity -1"),
              std::string::npos);
    EXPECT_NE(loss_of(area(R"({"type": "sphere"})")).find("has the type \"sphere\""), std::string::npos);
    MadeGltf flat = area(R"({"type": "rect"})");
    flat.root["nodes"][1]["scale"] = {0, 0, 0};
    EXPECT_NE(loss_of(flat).find("/nodes/1 is scaled to 0"), std::string::npos);
});

const Test disk("unit.gltf.light.disk", [] {
    const auto lid =
        light_of<scene::DiskLight>(area(R"({"type": "disk", "name": "Lid", "intensity": 50, "size": 3})"));
    EXPECT_EQ(lid.name, "Lid");
    EXPECT_EQ(lid.L, vec3(50));
    EXPECT_NEAR(lid.area(), 9.0f * pi, 1e-4f); // a diameter of 3 m, scaled by 2
    EXPECT_LT(glm::length(lid.normal() - vec3(0, 1, 0)), 1e-6f);
});

} // namespace
