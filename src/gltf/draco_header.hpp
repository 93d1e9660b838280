#pragma once
// The beginning of a Draco stream, looked at before the library allocates what it asks for.
#include "gltf/bytes.hpp"

#include <optional>

namespace sr::gltf {

/// Reads the number of triangles from a stream of the Draco bitstream 2.2 (specification, section 3). Absent
/// if it is none, is older, or ends too soon.
std::optional<std::uint64_t> draco_face_count(Bytes stream);

} // namespace sr::gltf
