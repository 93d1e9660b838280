#pragma once
// The two containers of glTF 2.0, a JSON text and GLB (specification, section 4.4), and the JSON in them.
// GLB wraps JSON and one buffer.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

using Bytes = std::span<const std::uint8_t>;

/// The parts of a file, as views into its bytes.
struct Container {
    std::string_view json;
    std::optional<Bytes> bin;    // GLB's first buffer
    std::size_t json_offset = 0; // of the JSON in the file [bytes]; not 0 in a GLB
    Bytes chunks{};              // a GLB's chunks behind the JSON, headers included

    bool is_glb() const { return json_offset != 0; }
};

/// Tells GLB from JSON by the first four bytes and checks every length that a GLB states against the file's
/// size. `name` is what errors call the file.
/// @throws Error
Container split_container(Bytes file, const std::string& name);

/// Builds a GLB of a JSON text, which it pads, and the chunks behind it.
std::vector<std::uint8_t> build_glb(std::string json, Bytes chunks);

/// Parses the container's JSON. A .gltf's errors carry line and column, a GLB's the byte of the file.
/// @throws Error if the text is no JSON, is nested deeper than 128 levels (recursive readers would exhaust
/// their stack), or is no object.
nlohmann::json parse(const Container& container, const std::string& name);

/// The same, with the members of each object in the file's order.
nlohmann::ordered_json parse_ordered(const Container& container, const std::string& name);

} // namespace sr::gltf
