// Broken files: whatever is done to a GLB, loading it succeeds or throws Error with one line, soon.
// Sanitizers watch (CMakePresets.json, sanitize). STERADIAN_FUZZ_RUNS sets the number of mutations,
// STERADIAN_FUZZ_SEED the first seed.
#include "core/error.hpp"
#include "gltf/asset.hpp"
#include "support/address.hpp"
#include "support/made_gltf.hpp"
#include "support/models.hpp"
#include "whole_gltf.hpp"

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

Bytes read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<Bytes> originals() {
    std::vector<Bytes> files{whole_gltf().glb(), MadeGltf::triangle().glb()};
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
        gltf::Asset asset(file);
        scene::Scene scene = asset.rest_pose();
        if (!asset.contents().animations.empty()) scene = asset.evaluate(std::move(scene), {{0}, 0.5});
        for (const std::string& line : asset.warnings())
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
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
    write_bytes(file, files[0]);
    expect_answer(file, errors);
    ASSERT_EQ(errors, 0) << "the file that has every part loads as long as nobody breaks it";
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
