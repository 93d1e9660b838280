#include "loading.hpp"

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

const Test bad_lights("unit.gltf.light.bad_ones_are_errors_naming_them", [] {
    EXPECT_EQ(error_of(punctual(R"({"type": "point", "name": "Key", "intensity": -1})")),
              "made.gltf: light \"Key\" (/extensions/KHR_lights_punctual/lights/0) has the intensity -1: "
              "give zero or more");
    EXPECT_NE(error_of(punctual(R"({"type": "point", "color": [1, -1, 1]})")).find("has the colour 1 -1 1"),
              std::string::npos);
    EXPECT_NE(error_of(punctual(R"({"type": "point", "range": -2})")).find("range"), std::string::npos);
    EXPECT_NE(error_of(punctual(R"({"type": "laser"})")).find("must be one of point, spot, directional"),
              std::string::npos);
    EXPECT_NE(error_of(punctual(R"({"type": "spot"})")), "");
    for (const char* cone :
         {R"({"innerConeAngle": -0.1})", R"({"innerConeAngle": 0.5, "outerConeAngle": 0.5})",
          R"({"innerConeAngle": 0.6, "outerConeAngle": 0.5})", R"({"outerConeAngle": 2})"}) {
        const std::string light = std::string(R"({"type": "spot", "spot": )") + cone + "}";
        EXPECT_NE(error_of(punctual(light.c_str())).find("0 <= inner < outer <= pi/2"), std::string::npos)
            << cone;
    }
});

const Test bad_reference("unit.gltf.light.a_reference_out_of_range_is_an_error", [] {
    MadeGltf made = punctual(R"({"type": "point"})");
    made.root["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 1;
    EXPECT_NE(error_of(made).find("/nodes/1/extensions/KHR_lights_punctual/light must be below 1"),
              std::string::npos);
    made.root.erase("extensions");
    EXPECT_NE(error_of(made).find("must be below 0"), std::string::npos);
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

const Test bad_areas("unit.gltf.light.bad_areas_are_errors_naming_them", [] {
    for (const char* bad : {R"("size": 0)", R"("size": -1)", R"("rect": {"aspect": 0})"}) {
        const std::string light = std::string(R"({"type": "rect", "name": "Panel", )") + bad + "}";
        EXPECT_NE(error_of(area(light.c_str()))
                      .find("light \"Panel\" (/extensions/EXT_lights_area/lights/0) has the size"),
                  std::string::npos)
            << bad;
    }
    EXPECT_NE(error_of(area(R"({"type": "rect", "intensity": -1})")).find("has the intensity -1"),
              std::string::npos);
    EXPECT_NE(error_of(area(R"({"type": "sphere"})")).find("has the type \"sphere\""), std::string::npos);
    MadeGltf flat = area(R"({"type": "rect"})");
    flat.root["nodes"][1]["scale"] = {0, 0, 0};
    EXPECT_NE(error_of(flat), "");
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
