#pragma once
// A glTF file with other lights and another camera, and all else as it was.
#include "viewer/lighting.hpp"

namespace sr::viewer {

/// Writes a copy of `loaded`'s file to `to`, beside it, in which lights and emissive materials are as
/// `lighting` has them now. What was not edited keeps its words. What was, is stated in extras.steradian.
/// With `view`, a new first camera looks from there.
/// @throws Error for another folder (what the file refers to would not be found) or ending, for two edited
/// lights at one node, and if the file cannot be written
void save(const LoadedScene& loaded, const Lighting& lighting, const scene::Camera* view,
          const std::string& to);

} // namespace sr::viewer
