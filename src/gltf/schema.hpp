#pragma once
// A check of a JSON value against a schema: kinds of values, required properties, lengths, indices in range.
//
// It precedes tinygltf, which takes the wrong kind of value for an absent one and narrows numbers unchecked.
// Every reader may rely on what it reads.
#include "gltf/warnings.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

struct Schema;

struct PropertySchema {
    PropertySchema(std::string_view name, Schema schema, bool is_required = false);

    std::string_view name;
    std::shared_ptr<const Schema> schema;
    bool is_required;
};

struct Schema {
    enum class Kind { anything, boolean, string, number, integer, index, array, object, dictionary };

    Kind kind = Kind::anything;
    std::vector<std::string_view> enum_values{}; // string: the only ones allowed; empty: any
    std::vector<std::uint64_t> enum_integers{};  // integer: the only ones allowed; empty: any
    std::uint64_t maximum = 0xFFFFFFFF;          // integer: GLB's own lengths are 32-bit
    std::string_view indexes_into{};             // index: the JSON pointer of an array
    std::shared_ptr<const Schema> items{};       // array, dictionary
    std::size_t length = 0;                      // array: the exact number of items; 0: any
    std::vector<PropertySchema> properties{};    // object
    bool additional_properties = true;           // object: others than `properties` are allowed
    bool is_optional = false;                    // object: a value that is no object passes

    /// Not empty: the value is one thing of the picture. A broken one is removed, and this says in a warning
    /// what is done without it.
    std::string_view loss{};
    /// Of a thing that other parts of the file refer to by its index: the JSON that replaces it. Empty: it is
    /// removed.
    std::string_view stand_in{};
    /// The value is addressed to this program (extras.steradian): a fault in it is an error even within a
    /// thing.
    bool is_ours = false;
};

inline PropertySchema::PropertySchema(std::string_view name, Schema schema, bool is_required)
    : name(name), schema(std::make_shared<const Schema>(std::move(schema))), is_required(is_required) {}

/// Schemas of the kinds of values, to build others from.
namespace schemas {

inline Schema boolean() { return {.kind = Schema::Kind::boolean}; }
inline Schema number() { return {.kind = Schema::Kind::number}; }
inline Schema string(std::vector<std::string_view> enum_values = {}) {
    return {.kind = Schema::Kind::string, .enum_values = std::move(enum_values)};
}
inline Schema integer(std::uint64_t maximum = 0xFFFFFFFF) {
    return {.kind = Schema::Kind::integer, .maximum = maximum};
}
inline Schema enum_integer(std::vector<std::uint64_t> values) {
    return {.kind = Schema::Kind::integer, .enum_integers = std::move(values)};
}
inline Schema index(std::string_view indexes_into) {
    return {.kind = Schema::Kind::index, .indexes_into = indexes_into};
}
inline Schema array(Schema items, std::size_t length = 0) {
    return {.kind = Schema::Kind::array,
            .items = std::make_shared<const Schema>(std::move(items)),
            .length = length};
}
inline Schema dictionary(Schema items) {
    return {.kind = Schema::Kind::dictionary, .items = std::make_shared<const Schema>(std::move(items))};
}
inline Schema object(std::vector<PropertySchema> properties = {}) {
    return {.kind = Schema::Kind::object, .properties = std::move(properties)};
}

/// A thing of the picture (Schema::loss).
inline Schema thing(Schema schema, std::string_view loss, std::string_view stand_in = {}) {
    schema.loss = loss;
    schema.stand_in = stand_in;
    return schema;
}

} // namespace schemas

/// The schema of glTF 2.0 for the parts that are read, and of the extensions that are supported.
const Schema& gltf_schema();

/// The schema of a textureInfo, with its KHR_texture_transform.
Schema texture_info_schema();

/// Schemas of the `extras` of a node, of a light of KHR_lights_punctual, of a material, of a scene and of the
/// asset: what glTF cannot say of lights and materials. Extras that are no objects, or have no "steradian",
/// pass. They are published as assets/extras.schema.json, and a test compares the two.
Schema node_extras_schema();
Schema light_extras_schema();
Schema material_extras_schema();
Schema scene_extras_schema();
Schema asset_extras_schema();

/// Checks `root`, rewrites integers that are written with a fraction ("3.0"), and removes the things that are
/// broken (Schema::loss).
/// @return the JSON pointers of the removed things, such as "/cameras/2"
/// @throws Error naming the offending value by its JSON pointer
std::set<std::string> check(nlohmann::json& root, const Schema& schema, const std::string& name,
                            Warnings& warnings);

} // namespace sr::gltf
