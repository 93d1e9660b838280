#include "core/file.hpp"
#include "support/address.hpp"
#include "support/models.hpp"
#include "unit/golden/suite_support.hpp"

#include <set>
#include <sstream>

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

/// Returns the error of load_suite for a text, without the folder.
std::string complaint(const std::string& text) {
    const auto folder = scratch_folder("suite_complaint");
    const auto file = written(folder / "s.json", text);
    const std::string error = error_of([&] { golden::load_suite(file); });
    return error.starts_with(folder.string()) ? error.substr(folder.string().size() + 1) : error;
}

const Test reads("unit.golden.suite.reads_all_keys", [] {
    const auto folder = scratch_folder("suite_reads");
    const auto suite = golden::load_suite(written(folder / "s.json", R"({
        "name": "mine", "goldens": "g", "laws": "l.xml", "renderer": {"GL_RENDERER": "llvmpipe"},
        "defaults": {"size": "8x8", "samples": 4, "tolerance": "rel=0.5", "time_limit": 2, "shaders": "o"},
        "tests": [{"name": "a", "scene": "dir/b.gltf", "samples": 9, "tags": ["x", "y"], "region": [1, 2, 3, 4],
                   "pixels": [{"at": [5, 6], "radiance": [1, 2, 3]}]},
                  {"name": "c", "command": ["t", "{out}"], "format": "png", "tolerance": ["abs=1", "flip=0.1"]}]})"));
    EXPECT_EQ(suite.name, "mine");
    EXPECT_EQ(suite.laws, folder / "l.xml");
    const golden::GoldenTest& a = suite.tests.at(0);
    EXPECT_EQ(a.command,
              (std::vector<std::string>{"{steradian}", "render", "dir/b.gltf", "-o", "{out}", "--strict",
                                        "--size", "8x8", "--samples", "9", "--shaders", "o"}));
    EXPECT_EQ(suite.golden_of(a), folder / "g" / "a.exr");
    EXPECT_EQ(a.guards, (std::vector<std::string>{"law.", "truth.b", "analytic.b"}));
    EXPECT_EQ(a.tolerances.at(0).limit, 0.5);
    EXPECT_EQ(a.time_limit, 2.0);
    EXPECT_EQ(a.region->height, 4);
    EXPECT_EQ(a.pixels.at(0).radiance, (std::array{1.0, 2.0, 3.0}));
    EXPECT_EQ(suite.tests.at(1).tolerances.size(), 2u);
    EXPECT_EQ(suite.golden_of(suite.tests.at(1)), folder / "g" / "c.png");
});

const Test places("unit.golden.suite.errors_name_line_and_column", [] {
    EXPECT_EQ(complaint("{\n \"tests\": [}"),
              "s.json:2:12: unexpected '}'; expected '[', '{', or a literal: correct the JSON there");
    EXPECT_EQ(
        complaint("{\"tests\": [\n {\"name\": \"a\", \"scene\": \"b\",\n  \"colour\": 1}]}").substr(0, 35),
        "s.json:3:13: unknown key \"colour\": ");
    EXPECT_EQ(complaint("{\"tests\": [\n  {\"scene\": \"b\"}]}"),
              "s.json:2:3: \"name\" is missing: add \"name\": \"…\"");
    EXPECT_EQ(
        complaint(
            "{\"tests\": [{\"name\": \"a\", \"scene\": \"b\"},\n {\"scene\": \"c\", \"name\":  \"a\"}]}"),
        "s.json:2:26: the name \"a\" is used twice: give each test its own");
    EXPECT_EQ(
        complaint("{\"tests\": [{\"name\": \"a\", \"scene\": \"b\", \"time_limit\": -1}]}").substr(0, 36),
        "s.json:1:54: \"time_limit\" is -1: wri");
});

const Test impossible("unit.golden.suite.refuses_what_cannot_work", [] {
    const auto has = [](const std::string& test, const std::string& what) {
        const std::string text = complaint("{\"tests\": [" + test + "]}");
        EXPECT_NE(text.find(what), std::string::npos) << text;
    };
    has(R"({"name": "../a", "scene": "b"})", "cannot be a file's");
    has(R"({"name": "-a", "scene": "b"})", "cannot be a file's");
    has(R"({"name": "a"})", "either a \"scene\" or a \"command\"");
    has(R"({"name": "a", "scene": "b", "command": ["c", "{out}"]})", "either a \"scene\" or a \"command\"");
    has(R"({"name": "a", "command": ["c"]})", "no {out}");
    has(R"({"name": "a", "command": "c  --x {out}"})", R"(write "command": ["c","--x","{out}"])");
    has(R"({"name": "a", "scene": "b", "tolerance": "nonsense"})", "tolerance");
    has(R"({"name": "a", "scene": "b", "format": "bmp"})", "unknown format");
    has(R"({"name": "a", "scene": 5})", "\"scene\" is a number");
    has("", "no tests");
    EXPECT_NE(complaint("[]").find("array where an object belongs"), std::string::npos);
    EXPECT_NE(complaint(std::string(100, '[') + std::string(100, ']')).find("nested deeper"),
              std::string::npos);
    EXPECT_NE(error_of([] { golden::load_suite("no/such.json"); }).find("no such file"), std::string::npos);
});

// The schema in assets/ is what editors check a suite with: it knows the keys that the program knows.
const Test schema("unit.golden.suite.schema_has_the_same_keys", [] {
    const auto file = read_text(assets_folder() / "golden_suite.schema.json");
    const auto json = nlohmann::json::parse(file);
    const auto keys_of = [&](const nlohmann::json& object) {
        std::set<std::string> keys;
        for (const auto& [key, value] : object.at("properties").items()) keys.insert(key);
        for (const auto& part : object.value("allOf", nlohmann::json::array())) {
            const auto place = nlohmann::json::json_pointer(part.at("$ref").get<std::string>().substr(1));
            for (const auto& [key, value] : json.at(place).at("properties").items()) keys.insert(key);
        }
        return keys;
    };
    const auto known = [](const std::string& text) { // "…: known here are a, b, c"
        const std::string error = complaint(text), mark = "known here are ";
        std::set<std::string> keys;
        std::istringstream words(error.substr(error.find(mark) + mark.size()));
        for (std::string word; words >> word;) keys.insert(word.substr(0, word.find(',')));
        return keys;
    };
    EXPECT_EQ(known(R"({"tests": [{"no": 1}]})"), keys_of(json["$defs"]["test"]));
    EXPECT_EQ(known(R"({"no": 1})"), keys_of(json));
});

// Whatever a file holds, the answer is a suite or one line.
const Test damaged("unit.golden.suite.any_damage_is_an_error", [] {
    const std::string text =
        R"({"name": "m", "defaults": {"size": "8x8"}, "tests": [{"name": "a\n\"b", "scene": "b",
        "pixels": [{"at": [5, 6], "radiance": [1, 2.5e3, -3]}], "tags": []}, {"name": "c", "command": ["{out}"]}]})";
    const auto folder = scratch_folder("suite_damaged");
    for (std::size_t i = 0; i < text.size(); ++i)
        for (const char c : {'\0', '"', '}', '[', ',', '9'}) {
            std::string broken = text;
            broken[i] = c;
            const auto file = written(folder / "s.json", broken);
            const std::string error = error_of([&] { golden::load_suite(file); });
            EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        }
});

} // namespace
