#include "golden/suite.hpp"

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json.hpp"
#include "golden/sha256.hpp"
#include "settings/options.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>
#include <sstream>

namespace sr::golden {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

void allow_test_keys(const JsonObject& entry) {
    std::vector<const char*> keys{
        "name",      "description",     "tags",   "scene", "command", "format", "arguments", "time_limit",
        "tolerance", "allow_nonfinite", "region", "mask",  "noise",   "pixels", "guards",    "renderer"};
    for (const settings::Option& option : settings::all_options())
        if (option.takers & settings::by_suites) keys.push_back(option.key);
    entry.allow_only(keys);
}

/// The key in the test if it is there, else in the defaults.
const JsonObject& holder(const JsonObject& entry, const JsonObject& defaults, const char* key) {
    return entry.has(key) ? entry : defaults;
}

/// The value of an option as the command line takes it: a text, or a number as written.
std::string option_value(const JsonObject& entry, const char* key) {
    const json& value = entry.value().at(key);
    if (value.is_string()) return value.get<std::string>();
    if (!value.is_number())
        entry.fail_at(key, fmt::format("\"{}\" is a {}", key, value.type_name()), "write a text or a number");
    return value.dump();
}

/// Appends an option to the words of a command, if the test or the defaults have it.
void append_option(std::vector<std::string>& words, const settings::Option& option, const JsonObject& entry,
                   const JsonObject& defaults) {
    using Kind = settings::Value::Kind;
    const char* const key = option.key;
    const JsonObject& place = holder(entry, defaults, key);
    if (option.value.kind == Kind::flag) {
        // A golden of a scene that has lost something would keep the loss.
        const bool is_strict = std::string_view(key) == "strict";
        if (place.flag(key, is_strict)) words.push_back(option.flag());
    } else if (option.value.kind == Kind::list) {
        for (const JsonObject* object : {&entry, &defaults})
            for (std::string& text : object->texts(key))
                words.insert(words.end(), {option.flag(), std::move(text)});
    } else if (place.has(key)) {
        words.insert(words.end(), {option.flag(), option_value(place, key)});
    }
}

std::vector<std::string> render_command(const JsonObject& entry, const JsonObject& defaults) {
    std::vector<std::string> words{"{steradian}", "render", entry.required_text("scene"), "-o", "{out}"};
    for (const settings::Option& option : settings::all_options())
        if (option.takers & settings::by_suites) append_option(words, option, entry, defaults);
    for (const JsonObject* place : {&entry, &defaults})
        for (std::string& word : place->texts("arguments")) words.push_back(std::move(word));
    return words;
}

std::string checked_name(const JsonObject& entry, std::set<std::string>& used) {
    std::string name = entry.required_text("name");
    bool fits = !name.empty() && name.size() <= 120 && name.front() != '.' && name.front() != '-';
    for (const char c : name) fits = fits && c != '/' && c != '\\' && static_cast<unsigned char>(c) >= 0x20;
    if (!fits)
        entry.fail_at(
            "name", "this name cannot be a file's",
            "use 1 to 120 characters without / \\ and control characters, not beginning with . or -");
    if (!used.insert(name).second)
        entry.fail_at("name", fmt::format("the name \"{}\" is used twice", name), "give each test its own");
    return name;
}

KnownPixel known_pixel(const JsonObject& entry) {
    entry.allow_only({"at", "radiance", "relative"});
    const auto at = entry.numbers("at", 2), rgb = entry.numbers("radiance", 3);
    if (at[0] < 0 || at[1] < 0 || at[0] > 65535 || at[1] > 65535)
        entry.fail_at("at", "no pixel of an image", "write [x, y], counted from the upper left");
    return {static_cast<int>(at[0]),
            static_cast<int>(at[1]),
            {rgb[0], rgb[1], rgb[2]},
            entry.number("relative", 0.01, 1e-9, 1.0)};
}

void read_comparison(GoldenTest& test, const JsonObject& entry, const JsonObject& defaults,
                     const fs::path& folder) {
    const JsonObject& tolerance = holder(entry, defaults, "tolerance");
    try {
        test.tolerances = compare::parse_tolerances(tolerance.texts("tolerance"));
    } catch (const Error& error) { // says what may stand there, and not where it stands
        tolerance.fail_at("tolerance", "a tolerance that does not parse", error.what());
    }
    test.allow_nonfinite = holder(entry, defaults, "allow_nonfinite").flag("allow_nonfinite", false);
    if (entry.has("region")) {
        const auto r = entry.numbers("region", 4);
        test.region = compare::PixelRegion{static_cast<int>(r[0]), static_cast<int>(r[1]),
                                           static_cast<int>(r[2]), static_cast<int>(r[3])};
    }
    if (entry.has("mask")) test.mask = entry.path("mask", entry.text("mask", ""), folder);
    for (const std::string& file : entry.texts("noise"))
        test.noise.push_back(entry.path("noise", file, folder));
    for (const JsonObject& pixel : entry.objects("pixels")) test.pixels.push_back(known_pixel(pixel));
}

/// Laws hold for every scene; a truth or closed form is of the scene that it names.
std::vector<std::string> default_guards(const std::string& scene) {
    if (scene.empty()) return {};
    const std::string stem = fs::path(scene).stem().string();
    return {"law.", "truth." + stem, "analytic." + stem};
}

/// The words of a command, one of which has {out}.
std::vector<std::string> external_command(const JsonObject& entry) {
    const json& value = entry.value().at("command");
    if (value.is_string()) {
        std::istringstream text(value.get<std::string>());
        json words = json::array();
        for (std::string word; text >> word;) words.push_back(word);
        entry.fail_at("command", "a command is a list of words, not one text",
                      fmt::format("write \"command\": {}", words.dump()));
    }
    std::vector<std::string> words = entry.texts("command");
    if (std::ranges::none_of(words, [](const std::string& word) { return word.find("{out}") != word.npos; }))
        entry.fail_at("command", "the command has no {out}", "put {out} where the image's file name belongs");
    return words;
}

std::string extension_of(const JsonObject& place) {
    constexpr std::array formats{"exr", "hdr", "png", "jpg", "jpeg", "tif", "tiff"};
    const std::string format = place.text("format", "exr");
    if (std::ranges::find(formats, format) == formats.end())
        place.fail_at("format", fmt::format("unknown format \"{}\"", format),
                      fmt::format("write one of {}", fmt::join(formats, ", ")));
    return "." + format;
}

GoldenTest read_test(const JsonObject& entry, const JsonObject& defaults, const fs::path& folder,
                     std::set<std::string>& used) {
    allow_test_keys(entry);
    GoldenTest test;
    test.name = checked_name(entry, used);
    test.description = holder(entry, defaults, "description").text("description", "");
    test.tags = holder(entry, defaults, "tags").texts("tags");
    if (entry.has("scene") == entry.has("command"))
        entry.fail("a test has either a \"scene\" or a \"command\"", "write one of the two");
    if (entry.has("scene")) {
        test.scene = entry.required_text("scene");
        test.command = render_command(entry, defaults);
    } else {
        test.command = external_command(entry);
    }
    test.extension = extension_of(holder(entry, defaults, "format"));
    // Without "defaults" they are the suite itself, whose "renderer" is its reference renderer.
    if (entry.has("renderer") || !defaults.has("tests"))
        test.renderer = holder(entry, defaults, "renderer").text("renderer", "");
    test.time_limit = holder(entry, defaults, "time_limit").number("time_limit", 60.0, 0.001, 86400.0);
    read_comparison(test, entry, defaults, folder);
    const JsonObject& guards = holder(entry, defaults, "guards");
    test.guards = guards.has("guards") ? guards.texts("guards") : default_guards(test.scene);
    return test;
}

} // namespace

Suite load_suite(const fs::path& file) {
    const JsonFile text(file);
    const JsonObject root(text, JsonObject::Pointer(""));
    root.allow_only({"$schema", "name", "goldens", "laws", "renderer", "defaults", "tests"});
    Suite suite;
    suite.file = file;
    suite.sha256 = sha256_text(read_text(file));
    suite.name = root.text("name", file.stem().string());
    suite.folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
    suite.goldens = root.path("goldens", root.text("goldens", "goldens"), suite.folder);
    if (root.has("laws")) suite.laws = root.path("laws", root.text("laws", ""), suite.folder);
    if (root.has("renderer")) {
        const JsonObject renderer(text, JsonObject::Pointer("/renderer"));
        renderer.allow_only({"GL_RENDERER", "GL_VERSION"});
        suite.renderer = {renderer.required_text("GL_RENDERER"), renderer.text("GL_VERSION", "")};
    }
    if (!root.has("tests")) root.fail("\"tests\" is missing", "add \"tests\": [ … ]");
    const JsonObject defaults(text, JsonObject::Pointer(root.has("defaults") ? "/defaults" : ""));
    if (root.has("defaults")) {
        allow_test_keys(defaults);
        for (const char* key : {"name", "scene", "command", "region", "mask", "noise", "pixels"})
            if (defaults.has(key))
                defaults.fail_at(key, fmt::format("\"{}\" has no default", key), "write it in each test");
    }
    std::set<std::string> used;
    for (const JsonObject& entry : root.objects("tests"))
        suite.tests.push_back(read_test(entry, defaults, suite.folder, used));
    if (suite.tests.empty())
        root.fail_at("tests", "no tests", "add one: { \"name\": \"…\", \"scene\": \"….gltf\" }");
    return suite;
}

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const Suite& suite) { return suite.goldens / "alternates"; }

} // namespace

fs::path alternate_of(const Suite& suite, const GoldenTest& test, std::string_view label) {
    return folder_of(suite) / label / (test.name + test.extension);
}

std::vector<std::string> alternates_of(const Suite& suite, const GoldenTest& test) {
    std::vector<std::string> labels;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(suite), ignored)) {
        const std::string label = entry.path().filename().string();
        if (fs::exists(alternate_of(suite, test, label), ignored)) labels.push_back(label);
    }
    std::ranges::sort(labels);
    return labels;
}

std::string file_name_of(const std::string& test) {
    constexpr std::size_t max_size = 200; // a file's name has at most 255 bytes
    std::string name;
    for (const char c : test)
        if (std::string_view("\":<>|*?%").find(c) == std::string_view::npos)
            name += c;
        else
            name += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    if (name.size() <= max_size) return name;
    return fmt::format("{}%{}", name.substr(0, name.find('%')), sha256_text(test).substr(0, 32));
}

std::vector<fs::path> orphans_of(const Suite& suite) {
    std::set<fs::path> known;
    for (const GoldenTest& test : suite.tests) {
        std::vector<fs::path> pictures{suite.golden_of(test)};
        for (const std::string& label : alternates_of(suite, test))
            pictures.push_back(alternate_of(suite, test, label));
        for (const fs::path& picture : pictures) {
            known.insert(picture.lexically_normal());
            known.insert(sidecar_of(picture).lexically_normal());
        }
        known.insert(test.mask.lexically_normal());
        for (const fs::path& noise : test.noise) known.insert(noise.lexically_normal());
    }
    std::vector<fs::path> orphans;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(suite.goldens, ignored)) {
        const bool is_hidden = entry.path().filename().string().starts_with('.');
        if (entry.is_regular_file(ignored) && !is_hidden && !known.contains(entry.path().lexically_normal()))
            orphans.push_back(entry.path());
    }
    std::ranges::sort(orphans);
    return orphans;
}

fs::path sidecar_of(const fs::path& picture) { return picture.string() + ".json"; }

void check_label(const std::string& label) {
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-'
               || c == '_' || c == '.';
    };
    if (!label.empty() && label.front() != '.' && std::ranges::all_of(label, is_plain)) return;
    throw Error(fmt::format("'{}' cannot name an alternate", label),
                "take letters, digits, '-', '_' and '.', such as radeonsi-24.1");
}

} // namespace sr::golden
