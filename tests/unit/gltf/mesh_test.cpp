#include "loading.hpp"

#include "gltf/read/mesh.hpp"

#include <array>
#include <limits>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

using Indices = std::vector<std::uint32_t>;

// Four corners of the unit square, lower left first, counter-clockwise.
MadeGltf square() {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["POSITION"] = made.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    made.attributes()["TEXCOORD_0"] = made.floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    made.primitive()["indices"] = made.shorts({0, 1, 2, 0, 2, 3});
    return made;
}

void add_normal_map(MadeGltf& made) {
    made.root["images"] = json::array({{{"uri", png_uri()}}});
    made.root["textures"] = json::array({{{"source", 0}}});
    made.root["materials"] = json::array({{{"normalTexture", {{"index", 0}}}}});
    made.primitive()["material"] = 0;
}

const Test modes("unit.gltf.mesh.strips_and_fans_become_triangles", [] {
    EXPECT_EQ(gltf::triangles({0, 1, 2, 3, 4}, 4), (Indices{0, 1, 2}));
    EXPECT_EQ(gltf::triangles({0, 1, 2, 3, 4}, 5), (Indices{0, 1, 2, 1, 3, 2, 2, 3, 4}));
    EXPECT_EQ(gltf::triangles({0, 1, 2, 3, 4}, 6), (Indices{1, 2, 0, 2, 3, 0, 3, 4, 0}));
    EXPECT_EQ(gltf::triangles({0, 1}, 5), Indices{});
    MadeGltf made = square();
    made.primitive()["indices"] = made.shorts({0, 1, 3, 2});
    made.primitive()["mode"] = 5;
    const scene::Mesh mesh = mesh_of(made);
    const std::vector<vec3> expected{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    ASSERT_EQ(mesh.indices.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(mesh.positions[mesh.indices[i]], expected[i]) << i;
});

const Test points_and_lines("unit.gltf.mesh.points_lines_loops_and_strips", [] {
    EXPECT_EQ(gltf::lines({0, 1, 2, 3, 4}, 1), (Indices{0, 1, 2, 3}));
    EXPECT_EQ(gltf::lines({0, 1, 2}, 2), (Indices{0, 1, 1, 2, 2, 0}));
    EXPECT_EQ(gltf::lines({0, 1, 2}, 3), (Indices{0, 1, 1, 2}));
    for (const int mode : {1, 2, 3}) EXPECT_EQ(gltf::lines({0}, mode), Indices{});
    const std::array<Indices, 4> expected{{{0, 1, 2}, {0, 1}, {0, 1, 1, 2, 2, 0}, {0, 1, 1, 2}}};
    for (int mode = 0; mode < 4; ++mode) {
        MadeGltf made = square();
        made.primitive()["mode"] = mode;
        made.primitive()["indices"] = made.shorts({1, 2, 3});
        const gltf::Loaded loaded = load(made);
        EXPECT_TRUE(loaded.warnings.empty());
        const scene::Mesh& mesh = loaded.scene.meshes.at(0);
        EXPECT_TRUE(mesh.indices.empty());
        EXPECT_FALSE(mesh.is_surface());
        EXPECT_EQ(mode == 0 ? mesh.points : mesh.lines, expected[static_cast<std::size_t>(mode)]);
        EXPECT_EQ(mesh.positions.size(), mode == 1 ? 2u : 3u) << "those that are used";
        EXPECT_EQ(mesh.positions[1], vec3(1, 1, 0));
        EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
    }
});

// glTF 2.0, section 3.9.7: what has no normals is unlit, and takes no flat ones.
const Test bare_points("unit.gltf.mesh.points_and_lines_have_the_normals_of_the_file_alone", [] {
    constexpr float inf = std::numeric_limits<float>::infinity();
    for (int mode = 0; mode < 4; ++mode) {
        MadeGltf made = square();
        add_normal_map(made);
        made.primitive()["mode"] = mode;
        made.attributes().erase("NORMAL");
        EXPECT_TRUE(mesh_of(made).normals.empty());
        EXPECT_TRUE(mesh_of(made).tangents.empty());
        made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 1}, "VEC3");
        const gltf::Loaded loaded = load(made);
        EXPECT_TRUE(warns_once(loaded, "a normal of a point or line is zero or not finite: the point"));
        EXPECT_EQ(loaded.scene.meshes.at(0).normals.at(1), vec3(0));
        EXPECT_EQ(loaded.scene.meshes.at(0).normals.at(2), vec3(0, 0, 1));
        made.attributes()["POSITION"] = made.floats({0, 0, 0, 1, 0, 0, 1, inf, 0, 0, 1, 0}, "VEC3");
        made.primitive()["indices"] = made.shorts({0, 1, 1, 2});
        const scene::Mesh rest = mesh_of(made);
        constexpr std::array<std::size_t, 4> kept{3, 2, 4, 4};
        EXPECT_EQ(mode == 0 ? rest.points.size() : rest.lines.size(), kept[static_cast<std::size_t>(mode)]);
        EXPECT_TRUE(warns_once(load(made), mode == 0 ? "a point has a position that is not finite"
                                                     : "a line has a position that is not finite"));
    }
});

const Test moved_lines("unit.gltf.mesh.lines_without_normals_follow_morph_targets", [] {
    MadeGltf made = square();
    made.primitive()["mode"] = 2;
    made.attributes().erase("NORMAL");
    made.primitive()["targets"] =
        json::array({{{"POSITION", made.floats(std::vector<float>(12, 1.0f), "VEC3")},
                      {"NORMAL", made.floats(std::vector<float>(12, 1.0f), "VEC3")}}});
    made.root["meshes"][0]["weights"] = {0.5};
    const scene::Mesh mesh = mesh_of(made);
    EXPECT_EQ(mesh.positions.at(0), vec3(0.5f));
    EXPECT_TRUE(mesh.normals.empty());
});

const Test generated_indices("unit.gltf.mesh.no_indices_means_vertices_in_order", [] {
    EXPECT_EQ(mesh_of(MadeGltf::triangle()).indices, (Indices{0, 1, 2}));
});

const Test index_sizes("unit.gltf.mesh.indices_of_8_16_and_32_bits", [] {
    MadeGltf made = square();
    made.primitive()["indices"] = made.accessor<std::uint8_t>({3, 2, 1}, "SCALAR", 5121);
    EXPECT_EQ(mesh_of(made).positions.at(mesh_of(made).indices.at(0)), vec3(0, 1, 0));
    made.primitive()["indices"] = made.accessor<std::uint32_t>({3, 2, 1}, "SCALAR", 5125);
    EXPECT_EQ(mesh_of(made).positions.at(mesh_of(made).indices.at(0)), vec3(0, 1, 0));
});

const Test bad_indices("unit.gltf.mesh.bad_indices_are_errors", [] {
    MadeGltf made = square();
    made.primitive()["indices"] = made.shorts({0, 1, 4});
    EXPECT_NE(error_of(made).find("/meshes/0/primitives/0/indices contains 4, and there are 4 vertices"),
              std::string::npos);
    made.primitive()["indices"] = made.shorts({0, 1, 65535});
    EXPECT_NE(error_of(made).find("primitive restart value 65535"), std::string::npos);
    made.primitive()["indices"] = made.accessor<std::uint8_t>({0, 1, 255}, "SCALAR", 5121);
    EXPECT_NE(error_of(made).find("primitive restart value 255"), std::string::npos);
});

const Test lengths("unit.gltf.mesh.attributes_must_be_as_many_as_positions", [] {
    MadeGltf made = square();
    made.attributes()["NORMAL"] = made.floats({0, 0, 1}, "VEC3");
    EXPECT_NE(error_of(made).find("/meshes/0/primitives/0 has 1 of NORMAL and 4 of POSITION"),
              std::string::npos);
});

const Test flat("unit.gltf.mesh.absent_normals_are_flat", [] {
    MadeGltf made = square();
    made.attributes()["POSITION"] = made.floats({0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 1, 0}, "VEC3"); // bent
    made.attributes().erase("NORMAL");
    made.attributes()["TANGENT"] = made.floats(std::vector<float>(16, 1.0f), "VEC4"); // to be ignored
    add_normal_map(made);
    const scene::Mesh mesh = mesh_of(made);
    ASSERT_EQ(mesh.positions.size(), 6u);
    ASSERT_EQ(mesh.normals.size(), 6u);
    EXPECT_LT(glm::length(mesh.normals[0] - glm::normalize(vec3(0, -1, 1))), 1e-6f);
    EXPECT_LT(glm::length(mesh.normals[5] - glm::normalize(vec3(-1, 0, 1))), 1e-6f);
    ASSERT_EQ(mesh.tangents.size(), 6u);
    EXPECT_NEAR(glm::dot(vec3(mesh.tangents[5]), mesh.normals[5]), 0.0f, 1e-6f);
    EXPECT_EQ(mesh.texcoords[0].size(), 6u);
});

const Test unit_normals("unit.gltf.mesh.normals_are_unit", [] {
    MadeGltf made = square();
    made.attributes()["NORMAL"] = made.floats({0, 0, 2, 0, 3, 4, 1e-4f, 0, 0, 0, 0, 1}, "VEC3");
    const scene::Mesh mesh = mesh_of(made);
    EXPECT_EQ(mesh.normals, (std::vector<vec3>{{0, 0, 1}, {0, .6f, .8f}, {1, 0, 0}, {0, 0, 1}}));
});

const Test bad_normals("unit.gltf.mesh.bad_normals_are_repaired_with_one_warning", [] {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    MadeGltf made = square();
    made.attributes()["NORMAL"] = made.floats({1, 0, 0, 0, 0, 0, nan, 0, 1, 0, 0, 1}, "VEC3");
    const gltf::Loaded loaded = load(made);
    EXPECT_EQ(loaded.scene.meshes[0].normals,
              (std::vector<vec3>{{1, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
    EXPECT_TRUE(warns_once(loaded, "a normal is zero or not finite (2 times)"));
});

const Test infinite("unit.gltf.mesh.infinite_positions_lose_their_triangles", [] {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    MadeGltf made = square();
    made.attributes()["POSITION"] = made.floats({0, 0, 0, infinity, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    const gltf::Loaded loaded = load(made);
    EXPECT_EQ(loaded.scene.meshes[0].indices.size(), 3u);
    EXPECT_EQ(loaded.scene.meshes[0].positions.size(), 3u);
    EXPECT_TRUE(warns_once(loaded, "a triangle has a position that is not finite: it is left out"));
});

const Test unused("unit.gltf.mesh.vertices_without_triangles_are_dropped", [] {
    MadeGltf made = square();
    made.primitive()["indices"] = made.shorts({0, 2, 3});
    const scene::Mesh mesh = mesh_of(made);
    EXPECT_EQ(mesh.positions, (std::vector<vec3>{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(mesh.indices, (Indices{0, 1, 2}));
    EXPECT_EQ(mesh.texcoords[0].at(1), vec2(1, 0));
});

const Test made_tangents("unit.gltf.mesh.a_normal_map_gets_tangents", [] {
    MadeGltf made = square();
    EXPECT_TRUE(mesh_of(made).tangents.empty());
    add_normal_map(made);
    EXPECT_EQ(mesh_of(made).tangents, std::vector<vec4>(4, vec4(1, 0, 0, 1)));
});

const Test file_tangents("unit.gltf.mesh.tangents_of_the_file_are_kept", [] {
    MadeGltf made = square();
    made.attributes()["TANGENT"] = made.floats({0, 2, 0, -1, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1}, "VEC4");
    EXPECT_TRUE(mesh_of(made).tangents.empty());
    add_normal_map(made);
    const gltf::Loaded loaded = load(made);
    const auto& tangents = loaded.scene.meshes[0].tangents;
    EXPECT_EQ(tangents.at(0), vec4(0, 1, 0, -1));
    EXPECT_EQ(tangents.at(1), vec4(0, 1, 0, 1));
    for (const vec4 tangent : tangents) EXPECT_NEAR(tangent.z, 0.0f, 1e-6f);
    EXPECT_TRUE(warns_once(loaded, "a tangent is zero, not finite or along its normal (2 times)"));
});

const Test mirror_split("unit.gltf.mesh.vertices_split_where_tangents_differ", [] {
    // Two squares side by side share the edge x = 1; u runs towards it from both sides.
    MadeGltf made = square();
    made.attributes() = {
        {"POSITION", made.floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0}, "VEC3")},
        {"NORMAL", made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")},
        {"TEXCOORD_0", made.floats({0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC2")}};
    made.primitive()["indices"] = made.shorts({0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2});
    add_normal_map(made);
    const scene::Mesh mesh = mesh_of(made);
    EXPECT_EQ(mesh.positions.size(), 8u); // the two shared vertices twice
    EXPECT_EQ(mesh.tangents.size(), 8u);
    for (std::size_t i = 0; i < 12; ++i) {
        const float side = i < 6 ? 1.0f : -1.0f;
        EXPECT_EQ(mesh.tangents[mesh.indices[i]], vec4(side, 0, 0, side)) << i;
    }
});

const Test no_texcoords("unit.gltf.mesh.a_texture_without_coordinates_is_warned_of", [] {
    MadeGltf made = square();
    made.attributes().erase("TEXCOORD_0");
    add_normal_map(made);
    const gltf::Loaded loaded = load(made);
    EXPECT_TRUE(warns_once(loaded, "mesh \"Mesh\" has a texture and no TEXCOORD_0"));
    for (const vec4 tangent : loaded.scene.meshes[0].tangents) EXPECT_NEAR(tangent.z, 0.0f, 1e-6f);
});

const Test no_positions("unit.gltf.mesh.no_positions_draws_nothing", [] {
    MadeGltf made = square();
    made.attributes().erase("POSITION");
    const gltf::Loaded loaded = load(made);
    EXPECT_TRUE(loaded.scene.instances.empty());
    EXPECT_TRUE(warns_once(loaded, "a primitive has no positions"));
    EXPECT_TRUE(warns_once(loaded, "there is nothing to see"));
});

} // namespace
