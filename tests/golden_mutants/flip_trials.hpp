#pragma once
// The share of harmless pictures that fail: edges of which chance chooses the pixels that fall to the other
// side.
#include "golden_mutants/bases.hpp"

#include <nlohmann/json.hpp>

namespace sr::testing {

/// For each base, 3 to 24 pixels and both directions of edges: how many of so many seeds fail, and why. A
/// small picture may not have as many such pixels.
nlohmann::ordered_json flip_trials(Extent size, int seeds);

} // namespace sr::testing
