// Broken files: whatever is done to a GLB, loading it succeeds or throws Error with one line, soon.
// Sanitizers watch (CMakePresets.json, sanitize). STERADIAN_FUZZ_RUNS sets the number of mutations,
// STERADIAN_FUZZ_SEED the first seed.
#include "core/error.hpp"
#include "gltf/load.hpp"
#include "support/address.hpp"
#include "support/made_gltf.hpp"
#include "support/models.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>

// AddressSanitizer's own hook: no allocation may exceed 1 GiB. Without the sanitizer nobody calls it.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() { return "max_allocation_size_mb=1024"; }

using namespace sr;
using namespace sr::testing;
using sr::testing::Test;

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

// Every part of the format that is read, in one small file.
MadeGltf everything() {
    MadeGltf made = MadeGltf::triangle();
    made.attributes()["NORMAL"] = made.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    made.attributes()["TEXCOORD_0"] = made.floats({0, 1, 1, 1, 0, 0}, "VEC2");
    made.attributes()["COLOR_0"] =
        made.accessor<std::uint8_t>({255, 0, 0, 0, 255, 0, 0, 0, 255}, "VEC3", 5121);
    made.primitive()["indices"] = made.shorts({0, 1, 2});
    made.primitive()["material"] = 0;
    json strip = made.primitive();
    strip.update({{"mode", 5}, {"indices", made.accessor<std::uint32_t>({0, 1, 2, 0}, "SCALAR", 5125)}});
    strip["attributes"].erase("NORMAL");
    made.root["meshes"][0]["primitives"].push_back(strip);
    made.root["accessors"].back().erase("bufferView"); // zeros
    const int places = made.accessor<std::uint32_t>({2}, "SCALAR", 5125);
    const int values = made.floats({0, 5, 0}, "VEC3");
    made.root["accessors"][0]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", made.root["accessors"][places]["bufferView"]}, {"componentType", 5125}}},
        {"values", {{"bufferView", made.root["accessors"][values]["bufferView"]}}}};
    made.root.update(json::parse(R"({
        "materials": [{"name": "m", "normalTexture": {"index": 0}, "emissiveFactor": [1, 1, 1],
            "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 1], "baseColorTexture": {"index": 0, "extensions":
                {"KHR_texture_transform": {"offset": [0, 1], "rotation": 1, "scale": [1, 2], "texCoord": 0}}}},
            "extensions": {"KHR_materials_specular": {"specularTexture": {"index": 0}}, "KHR_materials_ior": {"ior": 1.4}}}],
        "samplers": [{"magFilter": 9728, "minFilter": 9987}],
        "textures": [{"source": 0, "sampler": 0}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{"type": "spot", "spot": {"outerConeAngle": 0.5}}]},
                       "EXT_lights_area": {"lights": [{"type": "rect", "size": 2, "rect": {"aspect": 2}}]}},
        "nodes": [{"mesh": 0, "children": [1, 2]}, {"camera": 0, "translation": [1, 2, 3], "rotation": [0, 0, 0, 1]},
            {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "mesh": 0, "children": [3]},
            {"extensions": {"KHR_lights_punctual": {"light": 0}, "EXT_lights_area": {"light": 0}}, "scale": [1, 2, 3]}],
        "scene": 0})"));
    made.root["nodes"].push_back(
        json::parse(R"({"extras": {"steradian": {"shape": "disk", "radius": 1, "texture": 0,
        "temperature": 3000, "quantity": {"value": 9, "unit": "lm"}}}})"));
    made.root["nodes"].push_back(json::parse(R"({"extras": {"steradian": {"shape": "polygon", "corners":
        [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "spectrum": [[400, 1], [700, 2]], "quantity": {"value": 9, "unit": "W"}}}})"));
    made.root["extensions"]["EXT_lights_ies"]["lights"] = json::parse(R"([{"uri":
        "data:,TILT=NONE%0A1 -1 1 2 1 1 2 0 0 0 1 1 1 0 90 0 9 8"}])");
    made.root["nodes"].push_back(json::parse(R"({"extensions": {"EXT_lights_ies": {"light": 0}}})"));
    made.root["images"] = json::array({{{"uri", png_uri()}}});
    return made;
}

Bytes read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<Bytes> originals() {
    std::vector<Bytes> files{everything().glb(), MadeGltf::triangle().glb()};
    const auto folder = models_folder();
    if (!folder) return files;
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(*folder))
        if (entry.path().extension() == ".glb" && entry.file_size() < 16384) paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    for (const fs::path& path : paths) files.push_back(read(path));
    return files;
}

class Mutation {
public:
    explicit Mutation(std::uint32_t seed) : random_(seed) {}

    Bytes of(Bytes file) {
        const std::uint32_t kind = below(8);
        if (kind >= 4) return edit_json(std::move(file), kind);
        for (std::uint32_t times = 1 + below(4); times > 0 && file.size() > 24; --times) {
            if (kind == 0) file[place_in(file)] ^= static_cast<std::uint8_t>(1u << below(8));
            if (kind == 1) file.resize(below(file.size()));
            if (kind == 2) swap_words(file);
            if (kind == 3) put(file, place_in(file) / 4 * 4, extreme_words[below(std::size(extreme_words))]);
        }
        if (file.size() >= 12 && below(2) == 0) put(file, 8, static_cast<std::uint32_t>(file.size()));
        return file;
    }

private:
    static constexpr std::uint32_t extreme_words[] = {
        0, 1, 4, 0xFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x7F800000, 0x7FC00000};
    static constexpr const char* extreme_values[] = {"-1",
                                                     "0",
                                                     "1",
                                                     "2",
                                                     "3",
                                                     "255",
                                                     "65535",
                                                     "65536",
                                                     "2147483647",
                                                     "2147483648",
                                                     "4294967295",
                                                     "4294967296",
                                                     "1e18",
                                                     "18446744073709551615",
                                                     "-9223372036854775808",
                                                     "1e300",
                                                     "1e-300",
                                                     "0.5",
                                                     "null",
                                                     "true",
                                                     "[]",
                                                     "{}",
                                                     "\"x\"",
                                                     "[0]",
                                                     "[1,2,3]"};

    std::uint32_t below(std::size_t end) {
        return static_cast<std::uint32_t>(random_() % std::max<std::size_t>(end, 1));
    }
    void swap_words(Bytes& file) {
        const std::size_t a = 4 * below(file.size() / 4);
        const std::size_t b = 4 * below(file.size() / 4);
        const std::uint32_t word = get(file, a);
        put(file, a, get(file, b));
        put(file, b, word);
    }
    static void put(Bytes& file, std::size_t at, std::uint32_t word) {
        for (std::size_t i = 0; i < 4 && at + i < file.size(); ++i)
            file[at + i] = static_cast<std::uint8_t>(word >> (8 * i));
    }
    static std::uint32_t get(const Bytes& file, std::size_t at) {
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 4; ++i) word |= static_cast<std::uint32_t>(file[at + i]) << (8 * i);
        return word;
    }

    // Rewrites the JSON chunk and the lengths, so that what is wrong is the glTF and not its container.
    Bytes edit_json(Bytes file, std::uint32_t kind) {
        const std::size_t length = get(file, 12);
        std::string text(file.begin() + 20, file.begin() + 20 + static_cast<std::ptrdiff_t>(length));
        if (kind == 4)
            text[below(text.size())] = static_cast<char>(below(256));
        else {
            json root = json::parse(text);
            for (std::uint32_t times = 1 + below(3); times > 0; --times) {
                if (kind == 7)
                    edit(root);
                else
                    edit_number(root);
            }
            text = root.dump();
        }
        while (text.size() % 4 != 0) text += ' ';
        const auto json_begin = file.begin() + 20;
        Bytes edited = file;
        edited.resize(20 + text.size());
        std::copy(text.begin(), text.end(), edited.begin() + 20);
        std::copy(json_begin + static_cast<std::ptrdiff_t>(length), file.end(), std::back_inserter(edited));
        put(edited, 12, static_cast<std::uint32_t>(text.size()));
        put(edited, 8, static_cast<std::uint32_t>(edited.size()));
        return edited;
    }

    // Half of the places in the BIN chunk, which is small beside the JSON.
    std::size_t place_in(const Bytes& file) {
        const std::size_t bin = std::min<std::size_t>(20 + std::size_t{get(file, 12)}, file.size() - 1);
        return below(2) == 0 ? bin + below(file.size() - bin) : below(file.size());
    }

    // Any number of the file is as likely as any other.
    void edit_number(json& root) {
        const json leaves = root.flatten();
        std::vector<std::string> numbers;
        for (const auto& [pointer, value] : leaves.items())
            if (value.is_number()) numbers.push_back(pointer);
        if (numbers.empty()) return;
        json& number = root[json::json_pointer(numbers[below(numbers.size())])];
        if (below(4) == 0 && number.is_number_integer())
            number = number.get<std::int64_t>() + (below(2) == 0 ? 1 : -1);
        else
            number = json::parse(extreme_values[below(std::size(extreme_values))]);
    }

    // Goes down to some value and replaces, removes or repeats it.
    void edit(json& root) {
        json* parent = nullptr;
        json* here = &root;
        std::string key;
        while (here->is_structured() && !here->empty() && (parent == nullptr || below(8) != 0)) {
            parent = here;
            auto child = here->begin();
            std::advance(child, below(here->size()));
            if (here->is_object()) key = child.key();
            here = &*child;
        }
        if (!parent) return;
        const std::uint32_t how = below(8);
        if (how == 0 && parent->is_object())
            parent->erase(key);
        else if (how == 1 && parent->is_array())
            parent->push_back(json(*here));
        else if (how == 2 && here->is_number_integer())
            *here = here->get<std::int64_t>() + 1;
        else
            *here = json::parse(extreme_values[below(std::size(extreme_values))]);
    }

    std::mt19937 random_;
};

int number_from(const char* variable, int fallback) {
    const char* text = std::getenv(variable);
    return text ? std::atoi(text) : fallback;
}

// Loads the file; what is thrown must be an Error of one line, after less than 5 s.
void expect_answer(const fs::path& file, int& errors) {
    const auto start = std::chrono::steady_clock::now();
    try {
        const gltf::Loaded loaded = gltf::load(file);
        for (const std::string& line : loaded.warnings) EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    } catch (const Error& error) {
        ++errors;
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    } catch (const std::exception& other) {
        ADD_FAILURE() << "not an Error: " << other.what();
    }
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    EXPECT_LT(time.count(), 5.0);
}

const Test mutated("fuzz.gltf.mutated_glb", [] {
    const fs::path file = scratch_folder("fuzz.gltf") / "mutated.glb";
    const std::vector<Bytes> files = originals();
    const int first = number_from("STERADIAN_FUZZ_SEED", 0);
    const int runs = number_from("STERADIAN_FUZZ_RUNS", 2000);
    int errors = 0;
    for (int seed = first; seed < first + runs && !::testing::Test::HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        // Every other one is the file that has every part.
        const std::size_t which = seed % 2 == 0 ? 0 : static_cast<std::size_t>(seed / 2) % files.size();
        write_bytes(file, Mutation(static_cast<std::uint32_t>(seed)).of(files[which]));
        expect_answer(file, errors);
    }
    // Mutations that hardly ever hurt would test nothing, and so would files that never
    // load.
    EXPECT_GT(errors, runs / 4);
    EXPECT_LT(errors, runs * 19 / 20);
});

} // namespace
