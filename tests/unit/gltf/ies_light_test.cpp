#include "loading.hpp"
#include "scene/spectrum.hpp"

#include <cstring>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

constexpr const char* lamp =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 3 1 2 0 0 0\n1 1 10\n0 90\n0 90 180\n9 1 9 2 9 3\n";

// An IES light at (1, 2, 3).
MadeGltf with_ies(const json& light, const json& instance = {{"light", 0}}) {
    MadeGltf made = MadeGltf::triangle();
    made.root["extensions"]["EXT_lights_ies"]["lights"] = json::array({light});
    made.root["extensionsRequired"] = {"EXT_lights_ies"};
    made.root["nodes"].push_back(
        {{"name", "lamp"}, {"translation", {1, 2, 3}}, {"extensions", {{"EXT_lights_ies", instance}}}});
    made.root["scenes"][0]["nodes"] = {0, 1};
    return made;
}

// test_folder() starts afresh: the file is written between.
gltf::Loaded load_beside(const MadeGltf& made, const std::string& ies = lamp, bool is_strict = false) {
    const auto folder = test_folder();
    write_text(folder / "lamp.ies", ies);
    write_text(folder / "made.gltf", made.gltf());
    gltf::LoadOptions options;
    options.is_strict = is_strict;
    return gltf::load(folder / "made.gltf", options);
}

std::string error_beside(const MadeGltf& made, const std::string& ies, bool is_strict = false) {
    try {
        load_beside(made, ies, is_strict);
    } catch (const Error& error) {
        const std::string text = error.what();
        return text.substr(text.find("lamp.ies") == std::string::npos ? text.find("made.gltf")
                                                                      : text.find("lamp.ies"));
    }
    return "";
}

const Test file("unit.gltf.ies.a_file_beside_the_gltf", [] {
    const MadeGltf made =
        with_ies({{"uri", "lamp.ies"}}, {{"light", 0}, {"multiplier", 2}, {"color", {1, 0.5, 4}}});
    const scene::Scene scene = load_beside(made).scene;
    const auto light = std::get<scene::PointLight>(scene.lights.at(0));
    EXPECT_EQ(light.name, "lamp");
    EXPECT_EQ(light.position, vec3(1, 2, 3));
    EXPECT_EQ(light.I, vec3(2, 1, 2)) << "the extension clamps colours to 1";
    ASSERT_EQ(light.profile, 0);
    EXPECT_EQ(scene.profiles.at(0).gamma.size(), 2u);
    // Photometric zero is the node's -Z, horizontal 0 its X, 90 its Y; φ runs against the file's angle.
    EXPECT_EQ(light.world_from_profile * vec3(0, -1, 0), vec3(0, 0, -1));
    EXPECT_EQ(light.world_from_profile * vec3(1, 0, 0), vec3(1, 0, 0));
    EXPECT_EQ(light.world_from_profile * vec3(0, 0, 1), vec3(0, -1, 0));
});

const Test embedded("unit.gltf.ies.embedded_and_shared", [] {
    const MadeGltf by_uri = with_ies(
        {{"uri", "data:application/x-ies-lm-63;base64," + base64({lamp, lamp + std::strlen(lamp)})}});
    EXPECT_EQ(load(by_uri).scene.profiles.size(), 1u);
    MadeGltf by_view = with_ies({{"bufferView", 0}, {"mimeType", "application/x-ies-lm-63"}});
    const int offset = static_cast<int>(by_view.bytes.size());
    by_view.bytes.insert(by_view.bytes.end(), lamp, lamp + std::strlen(lamp));
    by_view.root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", std::strlen(lamp)}});
    by_view.root["extensions"]["EXT_lights_ies"]["lights"][0]["bufferView"] =
        by_view.root["bufferViews"].size() - 1;
    by_view.root["nodes"].push_back(by_view.root["nodes"][1]);
    by_view.root["scenes"][0]["nodes"] = {0, 1, 2};
    const scene::Scene scene = load(by_view).scene;
    EXPECT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.profiles.size(), 1u) << "a file is read once";
});

const Test stated("unit.gltf.ies.a_stated_flux", [] {
    MadeGltf made = with_ies({{"uri", "lamp.ies"}});
    made.root["nodes"][1]["extras"]["steradian"] = {{"quantity", {{"value", 500}, {"unit", "lm"}}},
                                                    {"radius", 0.1}};
    const scene::Scene scene = load_beside(made).scene;
    EXPECT_NEAR(scene::luminance(*scene::flux_of(scene.lights.at(0), scene.profiles)), 500.0, 0.01);
    EXPECT_FLOAT_EQ(std::get<scene::PointLight>(scene.lights.at(0)).radius, 0.1f);
    made.root["nodes"][1]["extras"]["steradian"] = {{"quantity", {{"value", 500}, {"unit", "cd"}}}};
    EXPECT_NE(error_beside(made, lamp).find("an IES light has the intensities of its file"),
              std::string::npos);
    made.root["nodes"][1].erase("extras");
    made.root["asset"]["extras"]["steradian"]["units"] = "radiometric";
    EXPECT_NEAR(std::get<scene::PointLight>(load_beside(made).scene.lights.at(0)).I.r, 1.0f / 683.0f, 1e-9f);
});

// The node's -Z is horizontal: the luminaire is turned by 90°.
const Test tilted("unit.gltf.ies.a_tilted_lamp", [] {
    std::string text = lamp;
    text.replace(text.find("TILT=NONE"), 9, "TILT=INCLUDE\n1\n2\n0 90\n1 0.25");
    EXPECT_FLOAT_EQ(
        std::get<scene::PointLight>(load_beside(with_ies({{"uri", "lamp.ies"}}), text).scene.lights.at(0))
            .I.r,
        0.25f);
    MadeGltf down = with_ies({{"uri", "lamp.ies"}});
    down.root["nodes"][1]["rotation"] = {-0.7071067811865476, 0, 0, 0.7071067811865476};
    EXPECT_NEAR(std::get<scene::PointLight>(load_beside(down, text).scene.lights.at(0)).I.r, 1.0f, 1e-6f);
});

/// The error under --strict; without it the lamp is off and there is a warning.
std::string loss_beside(const MadeGltf& made, const std::string& ies) {
    const gltf::Loaded loaded = load_beside(made, ies);
    EXPECT_TRUE(loaded.scene.lights.empty());
    EXPECT_EQ(loaded.warnings.size(), 1u);
    return error_beside(made, ies, true);
}

const Test bad("unit.gltf.ies.bad_files_cost_the_lamp_and_one_line", [] {
    const MadeGltf made = with_ies({{"uri", "lamp.ies"}});
    EXPECT_EQ(loss_beside(made, "no such thing\n"),
              "lamp.ies:1: there is no line that begins with TILT=: give an IES LM-63 file");
    std::string negative = lamp;
    negative.replace(negative.find("9 2"), 3, "9 -2");
    EXPECT_EQ(loss_beside(made, negative),
              "lamp.ies:7: a candela value is -2: give zero or more, as a 32-bit float can say it");
    MadeGltf missing = with_ies({{"uri", "none.ies"}});
    EXPECT_NE(loss_beside(missing, lamp)
                  .find("/extensions/EXT_lights_ies/lights/0/uri names \"none.ies\": no such file"),
              std::string::npos);
    EXPECT_NE(loss_of(with_ies({{"name", "x"}})).find("has not one of uri and bufferView"),
              std::string::npos);
    const MadeGltf broken = with_ies({{"uri", "data:,nothing"}});
    EXPECT_NE(loss_of(broken).find("made.gltf(/extensions/EXT_lights_ies/lights/0):1: there is no line"),
              std::string::npos);
    EXPECT_NE(loss_beside(with_ies({{"uri", "lamp.ies"}}, {{"light", 0}, {"multiplier", -1}}), lamp)
                  .find("has the intensity -1"),
              std::string::npos);
});

} // namespace
