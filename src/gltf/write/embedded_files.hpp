#pragma once
// A glTF's JSON that has within it what it refers to, so that it can be anywhere.
#include "gltf/container.hpp"
#include "gltf/source_file.hpp"

namespace sr::gltf {

/// Replaces each URI of a file beside `source` by that file's bytes. URIs of files that are not there stay.
/// @throws Error for an environment or a measured BRDF, which glTF names by a file only
void embed_files(nlohmann::ordered_json& gltf, const SourceFile& source);

/// Gives each buffer that is a file a data URI of the bytes that were read, where the file has changed since,
/// or is gone.
void embed_lost_buffers(nlohmann::ordered_json& gltf, const SourceFile& source);

/// Gives the buffer of a GLB a URI of its own, for a .gltf.
void embed_buffer(nlohmann::ordered_json& gltf, Bytes buffer);

} // namespace sr::gltf
