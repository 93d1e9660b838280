#pragma once
// Environments: from an equirectangular picture, and what a glTF scene says of one.
#include "gltf/document.hpp"
#include "gltf/warnings.hpp"
#include "scene/lights/light.hpp"

#include <optional>

namespace sr::gltf {

/// Reads a picture of linear radiance, .exr or .hdr, of any proportions up to 2^25 texels: it is stretched
/// over all directions. The first three channels are RGB, a single one is grey. Texels that are negative or
/// no numbers count as 0, infinite ones as 65504, the largest half float; `warnings` hears how many.
/// @throws Error for another format, a broken file, or a larger one
std::shared_ptr<const scene::EnvironmentMap> read_environment(const std::filesystem::path& file,
                                                              std::vector<std::string>& warnings);

/// Returns the environment that extras.steradian of the glTF scene states; absent if none. @throws Error
std::optional<scene::EnvironmentLight> parse_environment(const Document& document, std::optional<int> scene,
                                                         Warnings& warnings);

} // namespace sr::gltf
