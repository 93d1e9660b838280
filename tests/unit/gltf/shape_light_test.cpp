#include "gltf/schema.hpp"
#include "loading.hpp"
#include "scene/spectrum.hpp"

#include <fstream>
#include <set>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

// A node at (1, 2, 3), turned by 90° about x so that its -Z is the world's +Y and its Y the world's +Z,
// scaled by 2.
MadeGltf shaped(const std::string& stated) {
    MadeGltf made = MadeGltf::triangle();
    made.root["nodes"].push_back({{"name", "lamp"},
                                  {"translation", {1, 2, 3}},
                                  {"rotation", {0.7071067811865476, 0, 0, 0.7071067811865476}},
                                  {"scale", {2, 2, 2}},
                                  {"extras", {{"steradian", json::parse(stated)}}}});
    made.root["scenes"][0]["nodes"] = {0, 1};
    return made;
}

MadeGltf punctual(const std::string& stated, const char* light, const std::string& of_light = "{}") {
    MadeGltf made = shaped(stated);
    json item = json::parse(light);
    item["extras"]["steradian"] = json::parse(of_light);
    made.root["extensions"]["KHR_lights_punctual"]["lights"] = json::array({item});
    made.root["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
    return made;
}

constexpr const char* nits = R"("quantity": {"value": 100, "unit": "nit"})";

std::string with(const std::string& properties) { return "{" + properties + ", " + nits + "}"; }

const Test panel("unit.gltf.shape.rectangle", [] {
    const auto light = light_of<scene::RectangleLight>(shaped(
        with(R"("shape": "rectangle", "width": 3, "height": 1, "two_sided": true, "visible": false)")));
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.center, vec3(1, 2, 3));
    EXPECT_LT(glm::length(light.normal() - vec3(0, 1, 0)), 1e-6f);
    EXPECT_NEAR(std::abs(light.half_u.x), 3.0f, 1e-5f);
    EXPECT_NEAR(std::abs(light.half_v.z), 1.0f, 1e-5f);
    EXPECT_EQ(light.L, vec3(100));
    EXPECT_TRUE(light.is_two_sided);
    EXPECT_FALSE(light.is_visible);
});

const Test disks("unit.gltf.shape.disk_and_ellipse", [] {
    const auto disk = light_of<scene::DiskLight>(shaped(with(R"("shape": "disk", "radius": 0.5)")));
    EXPECT_NEAR(disk.area(), pi, 1e-5f);
    EXPECT_LT(glm::length(disk.normal() - vec3(0, 1, 0)), 1e-6f);
    const auto ellipse =
        light_of<scene::DiskLight>(shaped(with(R"("shape": "ellipse", "width": 4, "height": 1)")));
    EXPECT_NEAR(glm::length(ellipse.half_u), 4.0f, 1e-5f);
    EXPECT_NEAR(glm::length(ellipse.half_v), 1.0f, 1e-5f);
});

const Test round("unit.gltf.shape.sphere_and_tube", [] {
    const auto sphere = light_of<scene::SphereLight>(shaped(with(R"("shape": "sphere", "radius": 0.25)")));
    EXPECT_EQ(sphere.center, vec3(1, 2, 3));
    EXPECT_FLOAT_EQ(sphere.radius, 0.5f);
    const auto tube =
        light_of<scene::TubeLight>(shaped(with(R"("shape": "tube", "radius": 0.1, "length": 3)")));
    EXPECT_FLOAT_EQ(tube.radius, 0.2f);
    EXPECT_NEAR(std::abs(tube.half_axis.x), 3.0f, 1e-5f);
});

const Test polygon("unit.gltf.shape.polygon_keeps_its_front", [] {
    MadeGltf made = shaped(with(R"("shape": "polygon", "corners": [[0, 0, 0], [0, 1, 0], [1, 0, 0]])"));
    const auto light = light_of<scene::PolygonLight>(made); // clockwise from +Z: it emits along -Z
    EXPECT_LT(glm::length(light.normal() - vec3(0, 1, 0)), 1e-6f);
    EXPECT_NEAR(light.area(), 2.0f, 1e-5f);
    made.root["nodes"][1]["scale"] = {-2, 2, 2};
    EXPECT_LT(glm::length(light_of<scene::PolygonLight>(made).normal() - vec3(0, 1, 0)), 1e-6f);
});

/// Returns the world position of the point `uv` of an emitter's texture.
vec3 place_of(const scene::RectangleLight& light, vec2 uv) {
    const glm::mat2 along(light.map.along_u, light.map.along_v);
    const vec2 st = glm::inverse(along) * (uv - light.map.origin);
    return light.center + st.x * light.half_u + st.y * light.half_v;
}

const Test mirrored_texture("unit.gltf.shape.a_node_that_mirrors_mirrors_the_texture", [] {
    MadeGltf made = shaped(with(R"("shape": "rectangle", "width": 1, "height": 3, "texture": 0)"));
    made.root["images"] = json::array({{{"uri", png_uri()}}});
    made.root["textures"] = json::parse(R"([{"source": 0}])");
    made.root["nodes"][1].erase("rotation");
    made.root["nodes"][1].erase("translation");
    for (const vec3 scale : {vec3(1), vec3(-1, 1, 1), vec3(1, -1, 1), vec3(1, 1, -1), vec3(-1)}) {
        made.root["nodes"][1]["scale"] = {scale.x, scale.y, scale.z};
        const auto light = light_of<scene::RectangleLight>(made);
        // Seen from the front, along the node's +Z, its left is +X and its top +Y.
        for (const vec2 uv : {vec2(0.0f), vec2(1.0f, 0.0f), vec2(0.25f, 0.75f)}) {
            const vec3 expected = scale * vec3(0.5f - uv.x, 1.5f - 3.0f * uv.y, 0.0f);
            EXPECT_LT(glm::distance(place_of(light, uv), expected), 1e-6f) << scale.x << scale.y << scale.z;
        }
    }
});

const Test texture("unit.gltf.shape.a_texture_is_srgb", [] {
    MadeGltf made = shaped(with(R"("shape": "rectangle", "width": 1, "height": 1, "texture": 0)"));
    made.root["images"] = json::array({{{"uri", png_uri()}}});
    made.root["textures"] = json::parse(R"([{"source": 0}])");
    const scene::Scene scene = load(made).scene;
    const auto& light = std::get<scene::RectangleLight>(scene.lights.at(0));
    ASSERT_EQ(light.map.texture, 0);
    EXPECT_EQ(scene.textures.at(0).color_space, scene::ColorSpace::srgb);
    EXPECT_EQ(scene.images.size(), 1u);
    made.root["nodes"][1]["extras"]["steradian"]["texture"] = 1;
    EXPECT_NE(error_of(made).find("/nodes/1/extras/steradian/texture must be below 1"), std::string::npos);
});

const Test extras_of_lights("unit.gltf.shape.extras_of_punctual_lights", [] {
    const auto point = light_of<scene::PointLight>(punctual(
        R"({"radius": 0.1})", R"({"type": "point", "intensity": 5})", R"({"radius": 7, "visible": false})"));
    EXPECT_FLOAT_EQ(point.radius, 0.2f) << "what the node states goes before, and its scale counts";
    EXPECT_FALSE(point.is_visible);
    EXPECT_EQ(point.I, vec3(5));
    const auto sun = light_of<scene::DirectionalLight>(
        punctual(R"({"angular_diameter": 0.0093})", R"({"type": "directional", "intensity": 3})"));
    EXPECT_FLOAT_EQ(sun.angular_radius, 0.00465f);
    const auto warm = light_of<scene::PointLight>(
        punctual(R"({"temperature": 2700})", R"({"type": "point", "intensity": 5})"));
    EXPECT_NEAR(scene::luminance(warm.I), 5.0, 1e-5);
    EXPECT_GT(warm.I.r, 2.0f * warm.I.b);
});

// A quantity is what the light has, whatever its colour; without one glTF's product stays.
const Test stated_colors("unit.gltf.shape.a_stated_quantity_is_kept", [] {
    const auto red =
        light_of<scene::SphereLight>(shaped(with(R"("shape": "sphere", "radius": 1, "color": [1, 0, 0])")));
    EXPECT_NEAR(scene::luminance(red.L), 100.0, 1e-4);
    EXPECT_EQ(red.L.g, 0.0f);
    const auto point = light_of<scene::PointLight>(punctual(R"({"quantity": {"value": 40, "unit": "cd"}})",
                                                            R"({"type": "point", "color": [1, 0.5, 0]})"));
    EXPECT_NEAR(scene::luminance(point.I), 40.0, 1e-4);
    EXPECT_NEAR(point.I.g, 0.5f * point.I.r, 1e-5f);
});

// 683 lm/W, and numbers of a radiometric scene as they stand.
const Test systems("unit.gltf.shape.radiometric_scenes", [] {
    MadeGltf made = punctual(R"({"quantity": {"value": 2, "unit": "W/sr"}})", R"({"type": "point"})");
    EXPECT_NEAR(light_of<scene::PointLight>(made).I.r, 2 * 683.0f, 1e-3f);
    EXPECT_EQ(load(made).scene.units, scene::UnitSystem::photometric);
    made.root["asset"]["extras"]["steradian"]["units"] = "radiometric";
    EXPECT_EQ(load(made).scene.units, scene::UnitSystem::radiometric);
    EXPECT_FLOAT_EQ(light_of<scene::PointLight>(made).I.r, 2.0f);
    made.root["nodes"][1]["extras"]["steradian"] = {{"quantity", {{"value", 683}, {"unit", "cd"}}}};
    EXPECT_FLOAT_EQ(light_of<scene::PointLight>(made).I.r, 1.0f);
    made.root["nodes"][1].erase("extras");
    made.root["extensions"]["KHR_lights_punctual"]["lights"][0]["intensity"] = 7;
    EXPECT_FLOAT_EQ(light_of<scene::PointLight>(made).I.r, 7.0f);
    // A spectrum's own lumens: all of it at 555 nm, and half of the power where no eye sees.
    const auto lit = [](const char* spectrum) {
        return scene::luminance(
            light_of<scene::PointLight>(
                punctual(std::string(R"({"quantity": {"value": 1, "unit": "W/sr"}, "spectrum": )") + spectrum
                             + "}",
                         R"({"type": "point"})"))
                .I);
    };
    EXPECT_NEAR(lit("[[554, 0], [555, 1], [556, 0]]"), 683.0, 1.0);
    EXPECT_NEAR(lit("[[554, 0], [555, 1], [556, 0], [899, 0], [900, 1], [901, 0]]"), 341.5, 0.5);
});

const Test foreign("unit.gltf.shape.other_extras_are_left_alone", [] {
    MadeGltf made = shaped(with(R"("shape": "sphere", "radius": 1)"));
    for (const json& extras : {json("text"), json(5), json{{"other", {1, 2}}}, json(nullptr)}) {
        made.root["nodes"][1]["extras"] = extras;
        EXPECT_TRUE(load(made).scene.lights.empty());
    }
});

// The schema in assets/ is what editors check files with: it knows the properties and words that the program
// knows.
const Test schema("unit.gltf.shape.schema_and_rules_agree", [] {
    std::ifstream stream(assets_folder() / "extras.schema.json");
    const json definitions = json::parse(stream).at("$defs");
    const std::map<std::string, gltf::Schema> extras_schemas{{"node", gltf::node_extras_schema()},
                                                             {"light", gltf::light_extras_schema()},
                                                             {"material", gltf::material_extras_schema()},
                                                             {"scene", gltf::scene_extras_schema()},
                                                             {"asset", gltf::asset_extras_schema()}};
    const auto words_of = [](const json& list) { return list.get<std::set<std::string>>(); };
    const auto words_in = [](const gltf::Schema& schema) {
        return std::set<std::string>(schema.enum_values.begin(), schema.enum_values.end());
    };
    for (const auto& [name, extras] : extras_schemas) {
        const gltf::Schema& schema = *extras.properties.at(0).schema;
        const json& properties = definitions.at(name).at("properties");
        EXPECT_EQ(properties.size(), schema.properties.size()) << name;
        for (const gltf::PropertySchema& property : schema.properties) {
            ASSERT_TRUE(properties.contains(property.name)) << name << ' ' << property.name;
            const json& published = properties.at(std::string(property.name));
            EXPECT_EQ(published.contains("enum"), !property.schema->enum_values.empty()) << property.name;
            if (published.contains("enum")) {
                EXPECT_EQ(words_of(published["enum"]), words_in(*property.schema));
            }
        }
    }
    const gltf::Schema& quantity =
        *extras_schemas.at("material").properties.at(0).schema->properties.at(0).schema;
    ASSERT_EQ(quantity.properties.at(1).name, "unit");
    EXPECT_EQ(words_of(definitions["quantity"]["properties"]["unit"]["enum"]),
              words_in(*quantity.properties[1].schema));
});

// The example of the README is a scene.
const Test readme("unit.gltf.shape.the_example_of_the_readme", [] {
    std::ifstream stream(source_folder() / "src/gltf/README.md");
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    const auto begin = text.find("    \"nodes\": [\n");
    const auto end = text.find("\n    ]\n", begin);
    ASSERT_NE(end, std::string::npos);
    MadeGltf made = MadeGltf::triangle();
    made.root["nodes"] = json::parse("{" + text.substr(begin, end - begin) + "]}").at("nodes");
    made.root["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
    made.root["extensions"]["KHR_lights_punctual"]["lights"] =
        json::parse(R"([{"type": "point"}, {"type": "directional"}])");
    made.root["images"] = json::array({{{"uri", png_uri()}}});
    made.root["textures"] = json::parse(R"([{"source": 0}])");
    const scene::Scene scene = load(made).scene;
    ASSERT_EQ(scene.lights.size(), 5u);
    EXPECT_NEAR(scene::luminance(*scene::flux_of(scene.lights[1], {})), 800.0, 0.01);
    EXPECT_FLOAT_EQ(std::get<scene::PointLight>(scene.lights[2]).radius, 0.03f);
});

} // namespace
