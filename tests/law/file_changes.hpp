#pragma once
// Changes of a generated glTF file that its picture must follow. They share nothing with the code that loads.
#include "scene_changes.hpp"
#include "support/made_gltf.hpp"

namespace sr::testing {

/// All of the file's nodes under one root that moves, turns, scales and perhaps mirrors. Intensities, ranges,
/// fluxes and lenses, which nodes do not scale, go with the scale or its square, so that what arrives is the
/// same.
MadeGltf under_root(MadeGltf made, const Similarity& similarity);

/// The same light, stated in other units: cd, lm, lx and cd/m² for each other and for W/sr, W, W/m² and
/// W/(m² sr), where the emitter's form says how. IES files keep theirs.
MadeGltf in_other_units(MadeGltf made, Random& random);

/// Nodes, children and punctual lights in another order.
MadeGltf in_other_order(MadeGltf made, Random& random);

} // namespace sr::testing
