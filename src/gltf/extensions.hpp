#pragma once
// The table of glTF extensions: how each is supported, and the treatment of the others.
#include "gltf/schema.hpp"
#include "gltf/warnings.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>

namespace sr::gltf {

enum class Support {
    none,           // a warning, or an error where a file requires it
    texture_format, // each texture that has no PNG or JPEG beside it is lost, with a warning
    no_effect,      // it changes no picture
    full,           // the picture shows it
};

struct Extension {
    std::string_view name;
    Support support = Support::full;
    std::string_view notes{};     // what is supported, for the README
    bool (*is_built)() = nullptr; // not null: whether this build has the library that it needs
    Support unbuilt = Support::none;
    Schema (*of_material)() = nullptr; // the schema of its object in a material; null: it has none
};

/// All extensions that are known, sorted by support and name.
std::span<const Extension> known_extensions();

/// Returns whether pictures of this build show it.
bool is_supported(std::string_view extension);

/// The remedy for a file whose textures are KTX2 alone: no transcoder is packaged for Debian 12.
inline constexpr std::string_view convert_ktx =
    "convert its textures to PNG: gltf-transform ktxdecompress IN.glb OUT.glb (npm: @gltf-transform/cli)";

/// @throws Error naming every extension in `extensionsRequired` that is not supported and changes the
/// picture. Formats of textures pass: they cost their textures.
void check_required_extensions(const nlohmann::json& root, const std::string& name);

/// Adds one warning that names every extension in `extensionsUsed` that is not supported and changes the
/// picture as a whole.
void warn_of_unsupported(const std::vector<std::string>& extensions_used, Warnings& warnings);

} // namespace sr::gltf
