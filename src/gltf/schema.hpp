#pragma once
// A check of a JSON value against rules: kinds of values, required properties, lengths, and indices in range.
//
// It stands in front of tinygltf, which takes the wrong kind of value for an absent one and narrows numbers
// unchecked; behind it every reader may trust what it reads.
#include "gltf/warnings.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

struct Rule;

struct PropertyRule {
    std::string_view name;
    const Rule* rule = nullptr;
    bool is_required = false;
};

struct Rule {
    enum class Kind { anything, boolean, text, number, whole, index, list, record, dictionary };

    Kind kind = Kind::anything;
    std::string_view pool{};                // index: the JSON pointer of the array it counts in
    const Rule* element = nullptr;          // list, dictionary: what each element obeys
    std::size_t length = 0;                 // list: the exact number of elements; 0: any
    std::vector<PropertyRule> properties{}; // record: properties that are not listed may be anything, unless
    bool is_closed = false;                 // record: only those that are listed may be there
    bool is_optional = false;               // record: what is no object passes
    std::vector<std::string_view> words{};  // text: the only ones allowed; empty: any
    std::vector<std::uint64_t> values{};    // whole: the only ones allowed; empty: any
    std::uint64_t largest =
        0xFFFFFFFF; // whole: what is larger is a broken file (GLB's own lengths are 32-bit)

    /// Not empty: the value is one thing of the picture. Where it is broken it is taken out, and this says in
    /// a warning what is done without it.
    std::string_view loss{};
    /// A thing that other parts of the file count on by its index: the JSON that replaces it. Empty: it is
    /// removed.
    std::string_view stand_in{};
    /// The value is addressed to this program (extras.steradian): a fault in it is an error even within a
    /// thing.
    bool is_ours = false;
};

/// Returns the glTF 2.0 schema of the parts that this program reads, and of its extensions.
const Rule& gltf_rule();

/// Checks `root`, rewrites whole numbers that are written with a fraction ("3.0") as integers, and takes out
/// the things that are broken (Rule::loss).
/// @return the JSON pointers of the things that were taken out, such as "/cameras/2"
/// @throws Error naming the offending value by its JSON pointer
std::set<std::string> check(nlohmann::json& root, const Rule& rule, const std::string& name,
                            Warnings& warnings);

} // namespace sr::gltf
