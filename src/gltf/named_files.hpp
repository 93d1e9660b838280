#pragma once
// The files that a glTF names.
#include <filesystem>
#include <vector>

namespace sr::gltf {

/// The files beside a .gltf or .glb that its URIs may name (uri.hpp), whether or not they are there: buffers,
/// images, IES profiles, measured BRDFs. Empty where its JSON cannot be read.
std::vector<std::filesystem::path> named_files(const std::filesystem::path& file);

} // namespace sr::gltf
