#include "loading.hpp"

#include <cmath>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

template<typename T>
std::vector<vec2> texcoords_from(const std::vector<T>& numbers, int component_type, bool is_normalized) {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["TEXCOORD_0"] = made.accessor(numbers, "VEC2", component_type);
    made.root["accessors"].back()["normalized"] = is_normalized;
    return mesh_of(made).texcoords[0];
}

const Test component_types("unit.gltf.accessor.every_component_type_as_float", [] {
    EXPECT_EQ(texcoords_from<std::int8_t>({-2, 3, 0, 0, 0, 0}, 5120, false)[0], vec2(-2, 3));
    EXPECT_EQ(texcoords_from<std::uint8_t>({200, 3, 0, 0, 0, 0}, 5121, false)[0], vec2(200, 3));
    EXPECT_EQ(texcoords_from<std::int16_t>({-300, 3, 0, 0, 0, 0}, 5122, false)[0], vec2(-300, 3));
    EXPECT_EQ(texcoords_from<std::uint16_t>({60000, 3, 0, 0, 0, 0}, 5123, false)[0], vec2(60000, 3));
    EXPECT_EQ(texcoords_from<std::uint32_t>({70000, 3, 0, 0, 0, 0}, 5125, false)[0], vec2(70000, 3));
    EXPECT_EQ(texcoords_from<float>({0.25f, 3, 0, 0, 0, 0}, 5126, false)[0], vec2(0.25f, 3));
});

const Test normalized("unit.gltf.accessor.normalised_integers_are_fractions", [] {
    EXPECT_EQ(texcoords_from<std::int8_t>({-128, 127, 0, 0, 0, 0}, 5120, true)[0], vec2(-1, 1));
    EXPECT_EQ(texcoords_from<std::uint8_t>({51, 255, 0, 0, 0, 0}, 5121, true)[0], vec2(0.2f, 1));
    EXPECT_EQ(texcoords_from<std::int16_t>({-32768, 32767, 0, 0, 0, 0}, 5122, true)[0], vec2(-1, 1));
    EXPECT_EQ(texcoords_from<std::uint16_t>({13107, 65535, 0, 0, 0, 0}, 5123, true)[0], vec2(0.2f, 1));
});

const Test quantized("unit.gltf.accessor.quantised_positions_and_normals", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["extensionsRequired"] = {"KHR_mesh_quantization"};
    // Padded to four components' worth of bytes, as the extension demands.
    const int positions = made.accessor<std::int16_t>({0, 0, 0, 9, 5, 0, 0, 9, 0, 5, 0, 9}, "VEC4", 5122);
    made.root["accessors"][positions]["type"] = "VEC3";
    made.root["bufferViews"].back()["byteStride"] = 8;
    const int normals = made.accessor<std::int8_t>({0, 0, 127, 9, 0, 0, 127, 9, 0, 0, 127, 9}, "VEC4", 5120);
    made.root["accessors"][normals]["type"] = "VEC3";
    made.root["accessors"][normals]["normalized"] = true;
    made.root["bufferViews"].back()["byteStride"] = 4;
    made.attributes() = {{"POSITION", positions}, {"NORMAL", normals}};
    const scene::Mesh mesh = mesh_of(made);
    EXPECT_EQ(mesh.positions, (std::vector<vec3>{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}}));
    EXPECT_EQ(mesh.normals.at(2), vec3(0, 0, 1));
});

const Test interleaved("unit.gltf.accessor.interleaved_with_offsets", [] {
    MadeGltf made = MadeGltf::triangle();
    const int positions = made.floats({0, 0, 0, .5f, .6f, 2, 0, 0, .7f, .8f, 0, 2, 0, .9f, 1}, "SCALAR");
    made.root["accessors"][positions].update({{"type", "VEC3"}, {"count", 3}});
    made.root["bufferViews"].back()["byteStride"] = 20;
    json texcoords = made.root["accessors"][positions];
    texcoords.update({{"type", "VEC2"}, {"byteOffset", 12}});
    made.root["accessors"].push_back(texcoords);
    made.attributes() = {{"POSITION", positions}, {"TEXCOORD_0", positions + 1}};
    const scene::Mesh mesh = mesh_of(made);
    EXPECT_EQ(mesh.positions, (std::vector<vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}));
    EXPECT_EQ(mesh.texcoords[0], (std::vector<vec2>{{.5f, .6f}, {.7f, .8f}, {.9f, 1}}));
});

const Test sparse("unit.gltf.accessor.sparse", [] {
    MadeGltf made = MadeGltf::triangle();
    const int places = made.accessor<std::uint8_t>({2, 0}, "SCALAR", 5121);
    const int values = made.floats({0, 5, 0, 7, 7, 7}, "VEC3");
    made.root["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", made.root["accessors"][places]["bufferView"]}, {"componentType", 5121}}},
        {"values", {{"bufferView", made.root["accessors"][values]["bufferView"]}}}};
    EXPECT_EQ(mesh_of(made).positions, (std::vector<vec3>{{7, 7, 7}, {1, 0, 0}, {0, 5, 0}}));

    made.root["accessors"][0]["count"] = 2; // place 2 is now beyond
    EXPECT_NE(error_of(made).find("/accessors/0/sparse/indices contains 2, and the accessor has 2"),
              std::string::npos);
});

const Test zeros("unit.gltf.accessor.no_buffer_view_means_zeros", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["accessors"].push_back({{"componentType", 5126}, {"count", 3}, {"type", "VEC2"}});
    made.attributes()["TEXCOORD_0"] = 1;
    EXPECT_EQ(mesh_of(made).texcoords[0], std::vector<vec2>(3, vec2(0.0f)));
    made.root["accessors"][1]["count"] = 4000000000u;
    EXPECT_NE(error_of(made), "");
    made.attributes()["POSITION"] = 1;
    made.root["accessors"][1]["type"] = "VEC3";
    EXPECT_NE(error_of(made).find("asks for 4000000000 vertices"), std::string::npos) << error_of(made);
    made.root["accessors"][1]["count"] = 1000000u;
    EXPECT_NE(error_of(made).find("has 1000000 elements and no bufferView"), std::string::npos)
        << error_of(made);
});

const Test zero_indices("unit.gltf.accessor.indices_may_be_sparse_over_zeros", [] {
    MadeGltf made = MadeGltf::triangle();
    const int places = made.accessor<std::uint8_t>({1, 2}, "SCALAR", 5121);
    const int values = made.shorts({1, 2});
    made.root["accessors"].push_back(
        {{"componentType", 5123},
         {"count", 3},
         {"type", "SCALAR"},
         {"sparse",
          {{"count", 2},
           {"indices",
            {{"bufferView", made.root["accessors"][places]["bufferView"]}, {"componentType", 5121}}},
           {"values", {{"bufferView", made.root["accessors"][values]["bufferView"]}}}}}});
    made.primitive()["indices"] = 3;
    EXPECT_EQ(mesh_of(made).positions, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
});

const Test bounds("unit.gltf.accessor.nothing_is_read_out_of_bounds", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["accessors"][0]["count"] = 4;
    EXPECT_EQ(
        error_of(made),
        "made.gltf: /accessors/0 ends at byte 48 of /bufferViews/0, which has 36: export the file again");
    made = MadeGltf::triangle();
    made.root["accessors"][0]["byteOffset"] = 4294967295u;
    EXPECT_NE(error_of(made).find("/accessors/0 ends at byte 4294967331"), std::string::npos);
    made = MadeGltf::triangle();
    made.root["bufferViews"][0]["byteOffset"] = 4;
    EXPECT_EQ(error_of(made),
              "made.gltf: /bufferViews/0 ends at byte 40 of /buffers/0, which has 36: export the file again");
    made = MadeGltf::triangle();
    made.root["bufferViews"][0]["byteStride"] = 4;
    EXPECT_NE(error_of(made).find("byteStride is 4"), std::string::npos);
});

const Test components("unit.gltf.accessor.the_number_of_components_is_checked", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["accessors"][0]["type"] = "VEC2";
    EXPECT_NE(error_of(made).find("/accessors/0 has 2 components, and 3 are needed"), std::string::npos);
    made = MadeGltf::triangle();
    made.primitive()["indices"] = made.floats({0, 1, 2}, "SCALAR");
    EXPECT_NE(error_of(made).find("is not SCALAR of unsigned integers"), std::string::npos);
});

const Test colors("unit.gltf.accessor.colours_of_three_or_four_components", [] {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["COLOR_0"] =
        made.accessor<std::uint16_t>({65535, 0, 0, 0, 65535, 0, 0, 0, 65535}, "VEC3", 5123);
    made.root["accessors"].back()["normalized"] = true;
    EXPECT_EQ(mesh_of(made).colors.at(1), vec4(0, 1, 0, 1));
    made.attributes()["COLOR_0"] =
        made.accessor<std::uint8_t>({255, 0, 0, 51, 0, 0, 0, 0, 0, 0, 0, 0}, "VEC4", 5121);
    made.root["accessors"].back()["normalized"] = true;
    EXPECT_EQ(mesh_of(made).colors.at(0), vec4(1, 0, 0, 0.2f));
});

} // namespace
