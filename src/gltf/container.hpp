#pragma once
// The two containers of glTF 2.0: a JSON text, and GLB (specification, section 4.4), which wraps JSON and one
// buffer.
#include "gltf/bytes.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

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
Container split(Bytes file, const std::string& name);

/// Builds a GLB of a JSON text, which it pads, and the chunks behind it.
std::vector<std::uint8_t> glb_of(std::string json, Bytes chunks);

} // namespace sr::gltf
