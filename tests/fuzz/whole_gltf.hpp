#pragma once
#include "support/made_gltf.hpp"

namespace sr::testing {

/// Every part of the format that is read, in one small file.
MadeGltf whole_gltf();

} // namespace sr::testing
