// Containers, JSON, URIs: whatever comes before the glTF itself.
#include "loading.hpp"

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

std::string error_of_glb(const std::vector<std::uint8_t>& bytes) {
    const auto file = test_folder() / "made.glb";
    write_bytes(file, bytes);
    return error_at(file);
}

const Test glb_loads("unit.gltf.file.glb_loads", [] {
    const auto file = test_folder() / "made.glb";
    write_bytes(file, MadeGltf::triangle().glb());
    EXPECT_EQ(gltf::load(file).scene.meshes.at(0).positions.at(1), vec3(1, 0, 0));
});

const Test glb_lengths("unit.gltf.file.glb_lengths_are_checked", [] {
    const std::vector<std::uint8_t> good = MadeGltf::triangle().glb();
    std::vector<std::uint8_t> bad = good;
    bad.resize(good.size() - 1);
    EXPECT_EQ(error_of_glb(bad), "made.glb: the GLB says it is " + std::to_string(good.size())
                                     + " bytes long, and only " + std::to_string(bad.size())
                                     + " are here: copy or export the file again");
    bad = good;
    bad[4] = 1;
    EXPECT_EQ(error_of_glb(bad), "made.glb: GLB version 1 is not supported: convert the file to glTF 2.0");
    bad = good;
    bad[15] = 0x7F; // the JSON chunk's length
    EXPECT_NE(error_of_glb(bad).find("chunk at byte 12 says it is"), std::string::npos);
    bad = good;
    bad[16] = 'X';
    EXPECT_NE(error_of_glb(bad).find("first chunk of the GLB is not JSON"), std::string::npos);
    for (std::size_t size = 0; size < 24; ++size)
        EXPECT_NE(error_of_glb({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}), "") << size;
});

const Test broken_json("unit.gltf.file.broken_json_has_line_and_column", [] {
    const std::string error = error_of("{\n  \"asset\": {\n    \"version\": ,\n");
    EXPECT_TRUE(error.starts_with("made.gltf:3:16: this is not valid JSON (")) << error;
    EXPECT_TRUE(error_of("").starts_with("made.gltf: the file is empty"));
    EXPECT_TRUE(error_of("[]").starts_with("made.gltf: the JSON is not an object"));
    EXPECT_TRUE(error_of(R"({"asset":{"version":"2.0"},"extras":1e999})")
                    .starts_with("made.gltf: the JSON cannot be"));
});

const Test broken_json_in_glb("unit.gltf.file.broken_json_in_a_glb_has_its_byte", [] {
    std::vector<std::uint8_t> bytes = MadeGltf::triangle().glb();
    bytes[20] = '[';
    EXPECT_NE(error_of_glb(bytes).find("broken at byte 32 of the file (line 1, column 13 of the JSON"),
              std::string::npos)
        << error_of_glb(bytes);
});

const Test deep_json("unit.gltf.file.deep_json_is_refused", [] {
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    EXPECT_EQ(error_of(R"({"asset":{"version":"2.0"},"extras":)" + deep + "}"),
              "made.gltf: the JSON is nested deeper than 128 levels: flatten the extras "
              "or extensions that do so");
});

const Test versions("unit.gltf.file.other_versions_are_refused", [] {
    EXPECT_EQ(error_of("{}"),
              "made.gltf: this is not glTF 2.0, it has no asset.version: give a glTF 2.0 file");
    EXPECT_NE(error_of(R"({"asset":{"version":"1.0"},"scenes":{}})").find("convert it to glTF 2.0"),
              std::string::npos);
    EXPECT_NE(error_of(R"({"asset":{"version":"2.1","minVersion":"2.1"}})").find("needs a reader"),
              std::string::npos);
    EXPECT_EQ(error_of(R"({"asset":{"version":"2.1"}})"), "");
});

const Test absent("unit.gltf.file.an_absent_file_is_named", [] {
    const auto folder = test_folder();
    EXPECT_EQ(error_at(folder / "no.gltf"), "no.gltf: no such file: check the path");
    std::filesystem::create_directory(folder / "a.gltf");
    EXPECT_EQ(error_at(folder / "a.gltf"), "a.gltf: this is a folder: name a file");
});

MadeGltf with_buffer(const json& buffer) {
    MadeGltf made = MadeGltf::triangle();
    made.root["buffers"] = json::array({buffer});
    return made;
}

const Test files_beside("unit.gltf.file.files_beside_it_are_read", [] {
    const auto folder = test_folder();
    MadeGltf made = with_buffer({{"byteLength", 36}, {"uri", "in%20here/my%20buffer.bin"}});
    std::filesystem::create_directory(folder / "in here");
    write_bytes(folder / "in here" / "my buffer.bin", made.bytes);
    write_text(folder / "made.gltf", made.gltf());
    EXPECT_EQ(gltf::load(folder / "made.gltf").scene.meshes.at(0).positions.at(2), vec3(0, 1, 0));
    std::filesystem::resize_file(folder / "in here" / "my buffer.bin", 35);
    EXPECT_EQ(error_at(folder / "made.gltf"),
              "made.gltf: /buffers/0/byteLength is 36, and only 35 bytes are there: "
              "export the file again");
});

const Test absent_buffer("unit.gltf.file.an_absent_buffer_is_named", [] {
    EXPECT_EQ(error_of(with_buffer({{"byteLength", 36}, {"uri", "no.bin"}})),
              "made.gltf: /buffers/0/uri names \"no.bin\": no such file: check the path");
    EXPECT_NE(error_of(with_buffer({{"byteLength", 36}})).find("/buffers/0, which has no uri"),
              std::string::npos);
});

const Test containment("unit.gltf.file.uris_stay_in_the_folder", [] {
    const auto folder = test_folder() / "scene";
    std::filesystem::create_directories(folder / "inner");
    MadeGltf made = MadeGltf::triangle();
    write_bytes(folder.parent_path() / "secret.bin", made.bytes);
    write_bytes(folder / "inner" / "near.bin", made.bytes);
    const auto error_with = [&](const std::string& uri) {
        made.root["buffers"] = json::array({{{"byteLength", 36}, {"uri", uri}}});
        write_text(folder / "made.gltf", made.gltf());
        return error_at(folder / "made.gltf");
    };
    const std::string absolute = (folder.parent_path() / "secret.bin").string();
    for (const std::string& uri :
         {std::string("../secret.bin"), std::string("%2e%2e/secret.bin"), std::string("..%2Fsecret.bin"),
          std::string("inner/../../secret.bin"), std::string("..\\secret.bin"), absolute})
        EXPECT_NE(error_with(uri).find("leaves the folder"), std::string::npos) << uri;
    EXPECT_NE(error_with("http://example.com/a.bin").find("no file beside"), std::string::npos);
    EXPECT_NE(error_with("file:///etc/passwd").find("no file beside"), std::string::npos);
    EXPECT_NE(error_with("a%00b").find("names no file"), std::string::npos);
    EXPECT_NE(error_with("inner").find("this is a folder"), std::string::npos);
    EXPECT_EQ(error_with("inner/near.bin"), "");
    EXPECT_EQ(error_with("inner/../inner/near.bin"), "");
});

const Test data_uris("unit.gltf.file.data_uris_are_decoded", [] {
    EXPECT_EQ(load(MadeGltf::triangle()).scene.meshes.at(0).positions.at(2), vec3(0, 1, 0));
    EXPECT_EQ(error_of(with_buffer({{"byteLength", 36}, {"uri", "data:;base64,AA!A"}})),
              "made.gltf: /buffers/0/uri is not valid base64: export the file again");
    EXPECT_NE(error_of(with_buffer({{"byteLength", 36}, {"uri", "data:;base64,AAAA"}})).find("only 3 bytes"),
              std::string::npos);
    EXPECT_NE(error_of(with_buffer({{"byteLength", 36}, {"uri", "data:nothing"}})).find("without a comma"),
              std::string::npos);
});

const Test required("unit.gltf.file.required_extensions_are_named", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["extensionsRequired"] = {"EXT_old", "KHR_mesh_quantization", "EXT_new"};
    EXPECT_EQ(error_of(made), "made.gltf: it requires what is not supported yet, \"EXT_old\", \"EXT_new\": "
                              "export it without");
});

const Test used("unit.gltf.file.used_extensions_are_warned_of_once", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["extensionsUsed"] = {"A_a", "KHR_materials_ior", "B_b"};
    const gltf::Loaded loaded = load(made);
    EXPECT_EQ(loaded.warnings.size(), 1u);
    EXPECT_TRUE(
        warns_once(loaded, "made.gltf: it uses what is not supported yet, \"A_a\", \"B_b\": shown without"));
    EXPECT_EQ(loaded.contents.extensions_used.size(), 3u);
});

const Test kinds("unit.gltf.file.wrong_kinds_of_values_are_named", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["accessors"][0]["count"] = "three";
    EXPECT_EQ(error_of(made),
              "made.gltf: /accessors/0/count must be a whole number from 0 to 4294967295, and is \"three\": "
              "correct that value, or export the file again");
    made = MadeGltf::triangle();
    made.root["nodes"][0]["mesh"] = 1;
    EXPECT_NE(error_of(made).find("/nodes/0/mesh must be below 1, the number of /meshes, and is 1"),
              std::string::npos);
    made = MadeGltf::triangle();
    made.root["nodes"][0]["mesh"] = -1;
    EXPECT_NE(error_of(made).find("/nodes/0/mesh must be a whole number"), std::string::npos);
    made = MadeGltf::triangle();
    made.root["nodes"][0]["scale"] = {1, 2};
    EXPECT_NE(error_of(made).find("/nodes/0/scale must have 3 elements"), std::string::npos);
    made = MadeGltf::triangle();
    made.root["nodes"][0]["scale"] = {1, 2, 1e300};
    EXPECT_NE(error_of(made).find("/nodes/0/scale/2 must fit a 32-bit float"), std::string::npos);
    made = MadeGltf::triangle();
    made.attributes()["NORMAL"] = 17;
    EXPECT_NE(error_of(made).find("/meshes/0/primitives/0/attributes/NORMAL must be below 1"),
              std::string::npos);
    made = MadeGltf::triangle();
    made.root["accessors"][0].erase("type");
    EXPECT_NE(error_of(made).find("must have the property \"type\""), std::string::npos);
});

const Test whole_reals("unit.gltf.file.whole_numbers_may_have_a_fraction_of_zero", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["accessors"][0]["count"] = 3.0;
    made.root["nodes"][0]["mesh"] = 0.0;
    EXPECT_EQ(load(made).scene.instances.size(), 1u);
});

} // namespace
