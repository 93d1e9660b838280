#pragma once
// The glTF extensions that are read, and the treatment of the others.
#include "gltf/warnings.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace sr::gltf {

/// Returns whether pictures show it.
bool is_supported(std::string_view extension);

/// The remedy for a file whose textures are KTX2 alone: no transcoder is packaged for Debian 12.
inline constexpr std::string_view convert_ktx =
    "convert its textures to PNG: gltf-transform ktxdecompress IN.glb OUT.glb (npm: @gltf-transform/cli)";

/// @throws Error naming every extension in `extensionsRequired` that is not supported and changes the
/// picture. Formats of textures pass: they cost their textures.
void check_required_extensions(const nlohmann::json& root, const std::string& name);

/// One warning naming every extension in `extensionsUsed` that is not supported and changes the picture as a
/// whole.
void warn_of_unsupported(const std::vector<std::string>& extensions_used, Warnings& warnings);

} // namespace sr::gltf
