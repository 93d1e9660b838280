#include "core/error.hpp"
#include "mitsuba/write.hpp"
#include "support/address.hpp"
#include "support/models.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <span>
#include <sstream>

using namespace sr;
using namespace sr::testing;

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void expect_holds(const std::string& text, std::initializer_list<const char*> parts) {
    for (const char* part : parts)
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nis not in\n" << text;
}

/// One triangle, of a material with a name.
scene::Scene triangle() {
    scene::Scene scene;
    scene.materials.emplace_back().name = "clay";
    scene::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.normals.assign(3, vec3(0, 0, 1));
    mesh.indices = {0, 1, 2};
    scene.meshes.push_back(mesh);
    scene.instances.push_back({0, mat4(1.0f), "triangle"});
    return scene;
}

struct Written {
    fs::path folder;
    std::string xml;
    std::vector<std::string> warnings;
};

Written written(const scene::Scene& scene, const std::string& name, const scene::Camera& camera = {}) {
    Written result{scratch_folder("mitsuba_" + name) / "out", {}, {}};
    result.warnings = mitsuba::write({scene, camera, 40, 20}, result.folder);
    result.xml = text_of(result.folder / "scene.xml");
    return result;
}

const Test whole("unit.mitsuba.write.makes_all_that_rendering_takes", [] {
    const Written w = written(triangle(), "whole");
    EXPECT_TRUE(w.warnings.empty());
    for (const char* name : {"README.md", "render.py", "steradian_mitsuba/__init__.py", "meshes/0.ply"})
        EXPECT_TRUE(fs::file_size(w.folder / name) > 0) << name;
    expect_holds(w.xml, {"<integrator type=\"direct\">", "value=\"meshes/0.ply\"", "<ref id=\"material-0\"/>",
                         "<integer name=\"width\" value=\"40\"/>", "<rfilter type=\"box\">"});
});

const Test foreign("unit.mitsuba.write.leaves_a_foreign_folder_alone", [] {
    const fs::path parent = scratch_folder("mitsuba_foreign");
    fs::create_directory(parent / "out");
    std::ofstream(parent / "out" / "thesis.txt") << "three years";
    try {
        mitsuba::write({triangle(), {}, 8, 8}, parent / "out");
        ADD_FAILURE() << "it was overwritten";
    } catch (const Error& error) {
        expect_holds(error.what(), {"thesis.txt", "name a folder that is new or empty"});
    }
    EXPECT_EQ(text_of(parent / "out" / "thesis.txt"), "three years");
    EXPECT_EQ(std::distance(fs::directory_iterator(parent), {}), 1) << "nothing else was left";
});

const Test again("unit.mitsuba.write.replaces_an_earlier_export", [] {
    const fs::path parent = scratch_folder("mitsuba_again");
    scene::Scene scene = triangle();
    scene.instances.push_back(scene.instances[0]);
    mitsuba::write({scene, {}, 8, 8}, parent / "out");
    EXPECT_TRUE(fs::exists(parent / "out" / "meshes" / "1.ply"));
    mitsuba::write({triangle(), {}, 8, 8}, parent / "out");
    EXPECT_FALSE(fs::exists(parent / "out" / "meshes" / "1.ply"));
    EXPECT_EQ(std::distance(fs::directory_iterator(parent), {}), 1);
});

const Test nowhere("unit.mitsuba.write.names_a_parent_that_is_missing", [] {
    EXPECT_THROW(mitsuba::write({triangle(), {}, 8, 8}, scratch_folder("mitsuba_nowhere") / "no" / "out"),
                 Error);
});

const Test mirrored("unit.mitsuba.write.keeps_the_front_of_a_mirrored_instance", [] {
    scene::Scene scene = triangle();
    scene.instances[0].world_from_object[0].x = -1.0f;
    const std::string ply = text_of(written(scene, "mirrored").folder / "meshes" / "0.ply");
    std::array<std::int32_t, 3> corners{};
    std::memcpy(corners.data(), ply.data() + ply.size() - sizeof(corners), sizeof(corners));
    EXPECT_EQ(corners, (std::array<std::int32_t, 3>{2, 1, 0}));
});

const Test camera("unit.mitsuba.write.shows_what_the_renderer_shows", [] {
    scene::Camera wide; // a picture of 2:1 from a camera of 4:1 grows above and below
    wide.projection = scene::Perspective{0.5f, 4.0f, 0.1f, 50.0f};
    const float fov = 2.0f * std::atan(4.0f * std::tan(0.25f)) * 180.0f / pi;
    std::ostringstream expected;
    expected << "<float name=\"fov\" value=\"" << std::to_string(fov).substr(0, 6);
    expect_holds(written(triangle(), "camera", wide).xml,
                 {"<string name=\"fov_axis\" value=\"x\"/>", expected.str().c_str()});
});

const Test lights("unit.mitsuba.write.says_every_light", [] {
    scene::Scene scene = triangle();
    scene.profiles.push_back({"down", {0.0f, pi}, {0.0f, 2.0f * pi}, {1, 1, 1, 1}});
    scene::PointLight profiled;
    profiled.profile = 0;
    scene.lights = {profiled,
                    scene::PointLight{"", {1, 2, 3}, {4, 5, 6}},
                    scene::SpotLight{"", {1, 2, 3}, {0, -1, 0}, vec3(7.0f), 9.0f},
                    scene::DirectionalLight{"", {0, -1, 0}, {8, 9, 10}},
                    scene::DirectionalLight{"", {0, -1, 0}, vec3(1.0f), 0.5f},
                    scene::RectangleLight{},
                    scene::DiskLight{},
                    scene::SphereLight{"", {0, 1, 0}, 0.5f, {20, 21, 22}},
                    scene::TubeLight{},
                    scene::PolygonLight{"", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}};
    const Written w = written(scene, "lights");
    EXPECT_TRUE(w.warnings.empty());
    expect_holds(w.xml,
                 {"<string name=\"profile_gamma\" value=\"0 3.1415927\"/>",
                  "<vector name=\"intensity\" x=\"4\" y=\"5\" z=\"6\"/>",
                  "name=\"inverse_range\" value=\"0.11111111\"",
                  "<rgb name=\"irradiance\" value=\"8, 9, 10\"/>", "<shape type=\"rectangle\">",
                  "<shape type=\"disk\">", "<rgb name=\"radiance\" value=\"20, 21, 22\"/>", "meshes/1.ply"});
});

/// The XML of a material of that model.
std::string xml_of(scene::Model model, const std::function<void(scene::Material&)>& change = {}) {
    scene::Scene scene = triangle();
    scene.materials[0].model = model;
    if (change) change(scene.materials[0]);
    scene.meshes[0].tangents.assign(3, vec4(1, 0, 0, 1));
    const Written w = written(scene, "brdf");
    EXPECT_TRUE(w.warnings.empty());
    return w.xml;
}

const Test brdfs("unit.mitsuba.write.says_every_brdf", [] {
    using enum scene::Model;
    expect_holds(xml_of(lambert), {"\"steradian_framed\"", "<bsdf type=\"diffuse\" name=\"inner\">"});
    expect_holds(xml_of(mirror), {"\"steradian_framed\"", "<bsdf type=\"conductor\" name=\"inner\">"});
    expect_holds(xml_of(oren_nayar), {"\"steradian_oren_nayar\"", "name=\"roughness\""});
    expect_holds(xml_of(phong), {"\"steradian_phong\"", "name=\"exponent\"", "name=\"specular_color\""});
    expect_holds(xml_of(blinn_phong), {"\"steradian_blinn_phong\"", "name=\"exponent\""});
    expect_holds(xml_of(ggx, [](scene::Material& m) { m.roughness_across = 0.25f; }),
                 {"\"steradian_ggx\"", "name=\"roughness_across\" value=\"0.25\"", "vertex_tangent"});
    expect_holds(xml_of(conductor), {"\"steradian_conductor\"", "<vector name=\"n\"", "<vector name=\"k\""});
    const auto layers = [](scene::Material& m) {
        m.anisotropy = m.clearcoat = m.iridescence = 0.5f;
        m.sheen_color = vec3(0.5f);
    };
    expect_holds(xml_of(metallic_roughness, layers),
                 {"\"steradian_metallic_roughness\"", "\"anisotropy\"", "\"anisotropy_rotation\"",
                  "vertex_tangent", "\"clearcoat\"", "\"sheen_color\"", "\"iridescence\"", "\"film_ior\""});
    EXPECT_EQ(xml_of(metallic_roughness).find("sheen"), std::string::npos) << "a layer that is not there";
});

const Test measured("unit.mitsuba.write.writes_measured_brdfs_once", [] {
    scene::Scene scene = triangle();
    scene.measured.push_back({"made", std::vector<vec3>(scene::merl_cells, vec3(0.25f)), 0.5f});
    scene.materials.push_back(scene.materials[0]);
    for (scene::Material& material : scene.materials) {
        material.model = scene::Model::merl;
        material.measured = 0;
    }
    scene.meshes.push_back(scene.meshes[0]);
    scene.meshes[1].material = 1;
    scene.instances.push_back({1, mat4(1.0f), "other"});
    const Written w = written(scene, "measured");
    expect_holds(w.xml,
                 {"\"steradian_merl\"", "value=\"measured/0.binary\"", "name=\"alpha\" value=\"0.5\""});
    const std::string file = text_of(w.folder / "measured" / "0.binary");
    EXPECT_EQ(scene::read_merl(std::as_bytes(std::span(file)), "made").values[12345], vec3(0.25f));
    EXPECT_EQ(std::distance(fs::directory_iterator(w.folder / "measured"), {}), 1);
});

const Test sides("unit.mitsuba.write.gives_two_sided_emitters_two_shapes", [] {
    scene::Scene scene = triangle();
    scene::RectangleLight light;
    light.is_two_sided = true;
    scene.lights = {light};
    EXPECT_TRUE(fs::exists(written(scene, "sides").folder / "meshes" / "2.ply"));
});

const Test unsaid("unit.mitsuba.write.names_what_mitsuba_cannot_say", [] {
    scene::Scene scene = triangle();
    scene.profiles.push_back({"down", {0.0f, pi}, {0.0f, 2.0f * pi}, {1, 1, 1, 1}});
    scene::PointLight point{"lamp"};
    point.profile = 0;
    point.radius = 0.1f;
    scene::SpotLight spot{"beam"};
    spot.radius = 0.1f;
    scene.lights = {point, spot};
    scene.materials[0].alpha_mode = scene::AlphaMode::mask;
    scene.materials[0].metallic = 0.0f;
    scene.materials[0].transmission = scene.materials[0].diffuse_transmission = 0.5f;
    const auto warnings = written(scene, "unsaid").warnings;
    ASSERT_EQ(warnings.size(), 5u);
    expect_holds(warnings[0], {"'lamp'", "profile", "radius"});
    expect_holds(warnings[1], {"'beam'", "radius"});
    expect_holds(warnings[2], {"'clay'", "alpha mask"});
    expect_holds(warnings[3], {"'clay'", "glass"});
    expect_holds(warnings[4], {"'clay'", "transmits diffusely"});
});

} // namespace
