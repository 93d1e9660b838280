// Lights that make no sense: one clear line each.
#include "loading.hpp"

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

MadeGltf with_extras(const std::string& stated) {
    MadeGltf made = MadeGltf::triangle();
    made.root["nodes"].push_back({{"name", "lamp"}, {"extras", {{"steradian", json::parse(stated)}}}});
    made.root["scenes"][0]["nodes"] = {0, 1};
    return made;
}

void expect_error(const MadeGltf& made, std::string_view text) {
    const std::string error = error_of(made);
    EXPECT_NE(error.find(text), std::string::npos) << "found: " << error << "\nwanted: " << text;
    EXPECT_EQ(error.find('\n'), std::string::npos);
}

void expect_error(const std::string& stated, std::string_view text) {
    expect_error(with_extras(stated), text);
}

constexpr const char* lumens = R"("quantity": {"value": 1, "unit": "lm"})";

std::string shape(const std::string& properties) { return "{" + properties + ", " + lumens + "}"; }

const Test shapes("unit.gltf.bad_light.shapes", [] {
    EXPECT_EQ(error_of(with_extras(shape(R"("shape": "sphere", "radius": 0)"))),
              "made.gltf: light \"lamp\" (/nodes/1/extras/steradian) has the radius 0: give a positive one");
    expect_error(shape(R"("shape": "sphere", "radius": -1)"), "has the radius -1: give a positive one");
    expect_error(shape(R"("shape": "rectangle", "width": 0, "height": 1)"), "has the width 0");
    expect_error(shape(R"("shape": "tube", "radius": 1, "length": 0)"), "has the length 0");
    expect_error(shape(R"("shape": "sphere")"), "is a sphere without radius");
    expect_error(shape(R"("shape": "sphere", "radius": 1, "width": 2)"),
                 "a sphere has radius: leave width out");
    expect_error(shape(R"("shape": "cone", "radius": 1)"),
                 "must be one of rectangle, disk, ellipse, sphere, tube, polygon, and is \"cone\"");
    expect_error(shape(R"("shape": "sphere", "radios": 1)"),
                 "/nodes/1/extras/steradian may have shape, width");
    expect_error(R"({"shape": "sphere", "radius": 1})", "states no quantity");
    expect_error(shape(R"("radius": 1)"), "names no shape, and its node has no light");
    MadeGltf flat = with_extras(shape(R"("shape": "disk", "radius": 1)"));
    flat.root["nodes"][1]["scale"] = {1, 0, 1};
    EXPECT_NE(loss_of(flat).find("is scaled to nothing"), std::string::npos);
});

const Test polygons("unit.gltf.bad_light.polygons", [] {
    const auto corners = [](const char* list) {
        return shape(std::string(R"("shape": "polygon", "corners": )") + list);
    };
    expect_error(corners("[[0,0,0],[1,0,0]]"), "has fewer than three corners");
    expect_error(corners("[[0,0,0],[1,0,0],[2,0,0]]"), "has no area");
    expect_error(corners("[[0,0,0],[1,0,0],[1,0,0],[0,1,0]]"), "has corner 1 twice");
    expect_error(corners("[[0,0,0],[1,0,0],[1,1,0.1],[0,1,0]]"), "is not flat");
    expect_error(corners("[[0,0,0],[2,0,0],[1,0.5,0],[0,2,0]]"), "is not convex at corner 2");
    // A pentagram turns left at every corner, and around twice.
    expect_error(corners("[[1,0,0],[-0.809,0.588,0],[0.309,-0.951,0],[0.309,0.951,0],[-0.809,-0.588,0]]"),
                 "crosses itself");
    expect_error(corners("[[0,0],[1,0],[0,1]]"), "must have 3 elements");
});

const Test quantities("unit.gltf.bad_light.quantities", [] {
    const auto sphere = [](const std::string& quantity) {
        return R"({"shape": "sphere", "radius": 1, "quantity": )" + quantity + "}";
    };
    expect_error(sphere(R"({"value": -3, "unit": "lm"})"), "has the quantity -3 lm: give zero or more");
    expect_error(sphere(R"({"value": 3, "unit": "lumen"})"), "must be one of lm, cd, lx, cd/m^2");
    expect_error(sphere(R"({"value": 3})"), "must have the property \"unit\"");
    expect_error(sphere(R"({"value": "3", "unit": "lm"})"), "must be a number, and is \"3\"");
    expect_error(sphere(R"({"value": 3, "unit": "lx"})"),
                 "is stated in lx: state an area light in lm, cd or cd/m^2");
    expect_error(sphere(R"({"value": 1e38, "unit": "W"})"), "is brighter than 32-bit floats can say");
    std::string text = with_extras(sphere(R"({"value": 1234567, "unit": "lm"})")).gltf();
    const std::string nan = text.replace(text.find("1234567"), 7, "NaN");
    EXPECT_NE(error_of(nan).find("this is not valid JSON"), std::string::npos);
});

const Test bad_colors("unit.gltf.bad_light.colours", [] {
    const auto sphere = [](const std::string& more) {
        return shape(R"("shape": "sphere", "radius": 1, )" + more);
    };
    expect_error(sphere(R"("temperature": 10)"), "has the temperature 10 K");
    expect_error(sphere(R"("color": [0, 0, 0])"), "has the colour 0 0 0");
    expect_error(sphere(R"("color": [1, 1, 1], "temperature": 3000)"),
                 "has two of color, temperature and spectrum");
    expect_error(sphere(R"("spectrum": [[500, 1]])"), "has fewer than two points");
    expect_error(sphere(R"("spectrum": [[500, 1], [400, 1]])"), "has wavelengths that do not ascend");
    expect_error(sphere(R"("spectrum": [[500, 1], [600, -1]])"), "has a negative value");
    expect_error(sphere(R"("spectrum": [[0.5, 1], [0.6, 1]])"), "has nothing between 360 and 830 nm");
});

const Test bad_punctual("unit.gltf.bad_light.punctual", [] {
    const auto with_light = [](const char* type, const std::string& stated) {
        MadeGltf made = with_extras(stated);
        made.root["extensions"]["KHR_lights_punctual"]["lights"] =
            json::array({{{"type", type}, {"name", "Key"}}});
        if (std::string(type) == "spot")
            made.root["extensions"]["KHR_lights_punctual"]["lights"][0]["spot"] = json::object();
        made.root["nodes"][1]["extensions"]["KHR_lights_punctual"]["light"] = 0;
        return made;
    };
    expect_error(
        with_light("directional", "{" + std::string(lumens) + "}"),
        "is stated in lm: state a directional light in lx or W/m^2 (its beam is as wide as the scene");
    expect_error(with_light("point", R"({"radius": 0})"), "has the radius 0");
    expect_error(with_light("point", R"({"width": 1})"),
                 "/nodes/1/extras/steradian states width: the light of this node has radius, "
                 "angular_diameter, quantity");
    expect_error(with_light("spot", R"({"radius": -1})"), "has the radius -1");
    expect_error(with_light("point", R"({"angular_diameter": 0.1})"),
                 "has the angular_diameter of another kind");
    expect_error(with_light("directional", R"({"angular_diameter": 4})"), "between 0 and pi radians");
    expect_error(with_light("directional", R"({"radius": 1})"), "has the radius of another kind of light");
    expect_error(with_light("point", R"({"quantity": {"value": 1, "unit": "nit"}})"),
                 "with a radius also in cd/m^2");
    MadeGltf material = MadeGltf::triangle();
    material.root["materials"] = json::parse(
        R"([{"name": "glow", "extras": {"steradian": {"quantity": {"value": 1, "unit": "cd"}}}}])");
    material.primitive()["material"] = 0;
    expect_error(material, "material \"glow\" is stated in cd: state what a material emits in cd/m^2 or lm");
});

} // namespace
