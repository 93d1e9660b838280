// Containers, JSON, URIs: whatever comes before the glTF itself.
#include "gltf/extensions.hpp"
#include "gltf/uri.hpp"
#include "gltf/warnings.hpp"
#include "loading.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

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
                    .starts_with("made.gltf:1:37: the JSON cannot be read ("));
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
    EXPECT_EQ(error_of(R"({"asset":{"version":"1.0"},"scenes":{}})"),
              "made.gltf: this is glTF \"1.0\", not 2.0: convert it to glTF 2.0");
    EXPECT_EQ(error_of(R"({"asset":{"version":1}})"),
              "made.gltf: this is glTF \"1\", not 2.0: convert it to glTF 2.0");
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

// RFC 3986, sections 5.2.4, 2.1 and 3.1; and how exporters write names that they forget to encode.
const Test references("unit.gltf.file.uris_are_read_as_rfc_3986_says", [] {
    const auto folder = test_folder();
    std::filesystem::create_directories(folder / "in");
    MadeGltf made = MadeGltf::triangle();
    const auto error_with = [&](const std::string& uri, const std::string& file) {
        made.root["buffers"] = json::array({{{"byteLength", 36}, {"uri", uri}}});
        write_text(folder / "made.gltf", made.gltf());
        write_bytes(folder / file, made.bytes);
        std::string error = error_at(folder / "made.gltf");
        const auto named = gltf::named_files(made.root, folder); // what the viewer watches
        if (std::ranges::find(named, folder / file) == named.end()) error += " (not watched)";
        std::filesystem::remove(folder / file);
        return error;
    };
    for (const auto& [uri, file] :
         std::vector<std::pair<std::string, std::string>>{{"sub/../x.bin", "x.bin"},
                                                          {"./x.bin", "x.bin"},
                                                          {"in/./../in/x.bin", "in/x.bin"},
                                                          {"sub/%2e%2e/x.bin", "x.bin"},
                                                          {"x%2Ebin", "x.bin"},
                                                          {"a%20b.bin", "a b.bin"},
                                                          {"a b.bin", "a b.bin"},
                                                          {"50%off.bin", "50%off.bin"},
                                                          {"50%25off.bin", "50%off.bin"},
                                                          {"50%ad.bin", "50%ad.bin"},
                                                          {"C#.bin", "C#.bin"},
                                                          {"x.bin?v=2", "x.bin"},
                                                          {"x.bin#part", "x.bin"},
                                                          {"what?.bin", "what?.bin"},
                                                          {"in\\x.bin", "in/x.bin"},
                                                          {"%C3%A9.bin", "\u00e9.bin"},
                                                          {"\u00e9.bin", "\u00e9.bin"},
                                                          {"100%", "100%"}})
        EXPECT_EQ(error_with(uri, file), "") << uri;
    EXPECT_NE(error_with("sub/../../x.bin", "x.bin").find("leaves the folder"), std::string::npos);
    EXPECT_NE(error_with("C:\\x.bin", "x.bin").find("no file beside"), std::string::npos);
    EXPECT_NE(error_with("//host/x.bin", "x.bin").find("leaves the folder"), std::string::npos);
});

const Test data_case("unit.gltf.file.the_scheme_of_a_data_uri_has_any_case", [] {
    MadeGltf made = MadeGltf::triangle();
    for (const char* head : {"DATA:application/octet-stream;base64,", "Data:;BASE64,", "data:;Base64,"}) {
        made.root["buffers"] = json::array({{{"byteLength", 36}, {"uri", head + base64(made.bytes)}}});
        EXPECT_EQ(error_of(made), "") << head;
    }
});

const Test strict("unit.gltf.file.strict_makes_any_warning_an_error", [] {
    MadeGltf made = MadeGltf::triangle();
    made.root["extensionsUsed"] = {"A_a"};
    gltf::LoadOptions options;
    EXPECT_EQ(error_of(made, options), "");
    options.is_strict = true;
    EXPECT_EQ(
        error_of(made, options),
        "made.gltf: it uses what is not supported yet, \"A_a\": correct it, or leave out --strict (then: "
        "shown without, which may look different)");
});

const Test many("unit.gltf.file.many_warnings_are_summed_up", [] {
    gltf::Warnings warnings("made.gltf");
    for (int i = 0; i < 1000; ++i) warnings.add("thing " + std::to_string(i), "left out");
    for (int i = 0; i < 1000; ++i) warnings.add("thing 5", "left out");
    const std::vector<std::string> lines = warnings.lines();
    ASSERT_EQ(lines.size(), gltf::Warnings::max_lines + 1);
    EXPECT_EQ(lines[5], "made.gltf: thing 5 (1001 times): left out");
    EXPECT_EQ(lines.back(), "made.gltf: 900 further warnings: correct these first");
});

const Test data_uris("unit.gltf.file.data_uris_are_decoded", [] {
    EXPECT_EQ(load(MadeGltf::triangle()).scene.meshes.at(0).positions.at(2), vec3(0, 1, 0));
    const std::string plain = base64({0xFB, 0xEF, 0xBE, 0xFF, 0xFF, 0xFF, 0x01});
    ASSERT_EQ(plain, "++++////AQ==");
    for (const char* text : {"++++////AQ==", "++++////AQ", "----____AQ==", " ++++\n////\r\n\tAQ== \n",
                             "%2B%2B%2B%2B////AQ%3D%3D", "++++////AQ=\n="}) {
        const MadeGltf file = with_buffer({{"byteLength", 7}, {"uri", std::string("data:;base64,") + text}});
        EXPECT_NE(error_of(file).find("of /buffers/0, which has 7"), std::string::npos)
            << text << ": " << error_of(file);
    }
    EXPECT_NE(
        error_of(with_buffer({{"byteLength", 36}, {"uri", "data:;base64,AAAAA"}})).find("not valid base64"),
        std::string::npos);
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

const Test harmless("unit.gltf.file.extensions_that_change_no_picture_are_no_matter", [] {
    for (const char* name : {"FB_ngon_encoding", "KHR_xmp_json_ld", "EXT_structural_metadata", "MSFT_lod",
                             "KHR_physics_rigid_bodies", "KHR_interactivity", "KHR_audio_emitter",
                             "MSFT_texture_dds", "EXT_texture_avif", "KHR_texture_basisu"}) {
        MadeGltf made = MadeGltf::triangle();
        made.root["extensionsUsed"] = made.root["extensionsRequired"] = {name};
        gltf::LoadOptions strict;
        strict.is_strict = true;
        EXPECT_EQ(error_of(made, strict), "") << name;
    }
});

// The README's table of extensions is extensions.cpp's.
const Test readme("unit.gltf.file.readme_has_the_extensions", [] {
    std::ifstream stream(source_folder() / "src/gltf/README.md");
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    std::string expected = "| extension | supported |\n|---|---|\n";
    for (const gltf::Extension& extension : gltf::known_extensions())
        if (extension.support != gltf::Support::no_effect)
            expected += fmt::format("| `{}` | {} |\n", extension.name,
                                    extension.notes.empty() ? "yes" : extension.notes);
    EXPECT_NE(text.find(expected), std::string::npos) << expected;
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

// Cases from public bug reports of other readers.
const Test oddities("unit.gltf.file.what_is_odd_and_valid_loads_without_a_word", [] {
    const auto expect_triangle = [](const gltf::Loaded& loaded) {
        EXPECT_TRUE(loaded.warnings.empty()) << ::testing::PrintToString(loaded.warnings);
        ASSERT_EQ(loaded.scene.instances.size(), 1u);
        EXPECT_EQ(loaded.scene.meshes.at(0).positions.at(1), vec3(1, 0, 0));
    };
    const MadeGltf plain = MadeGltf::triangle();
    expect_triangle(load_text("\xEF\xBB\xBF" + plain.gltf())); // a byte order mark
    std::vector<std::uint8_t> glb = plain.glb();
    glb.insert(glb.end(), {1, 2, 3, 4, 5}); // beyond the length that the header states
    const auto file = test_folder() / "made.glb";
    write_bytes(file, glb);
    expect_triangle(gltf::load(file));
    for (const json& extra : std::vector<json>{1, "text", json::array({1, 2}), nullptr, true}) {
        MadeGltf made = MadeGltf::triangle();
        made.root["extras"] = made.root["asset"]["extras"] = made.root["nodes"][0]["extras"] = extra;
        made.primitive()["extras"] = made.root["accessors"][0]["extras"] = extra;
        expect_triangle(load(made));
    }
    MadeGltf twins = MadeGltf::triangle(); // names that occur twice, a node without anything, an unused scene
    twins.root["nodes"][0]["name"] = "same";
    twins.root["nodes"].push_back({{"name", "same"}});
    twins.root["scenes"][0]["nodes"] = {0, 1};
    twins.root["scenes"].push_back(json::object());
    expect_triangle(load(twins));
    twins.root.erase("scenes"); // then all nodes
    twins.root.erase("scene");
    expect_triangle(load(twins));
    MadeGltf empty = MadeGltf::triangle(); // a mesh of no primitives, one without positions
    empty.root["meshes"].push_back({{"primitives", json::array()}});
    empty.root["nodes"].push_back({{"mesh", 1}});
    empty.root["scenes"][0]["nodes"] = {0, 1};
    expect_triangle(load(empty));
    MadeGltf long_rotation = MadeGltf::triangle(); // no unit quaternion
    long_rotation.root["nodes"][0]["rotation"] = {0, 0, 2, 0};
    EXPECT_LT(glm::length(load(long_rotation).scene.instances.at(0).world_from_object * vec4(1, 0, 0, 0)
                          - vec4(-1, 0, 0, 0)),
              1e-6f);
});

} // namespace
