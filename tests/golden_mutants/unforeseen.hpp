#pragma once
// Mutants of kinds that no rule was made in sight of.
#include "golden_mutants/painting.hpp"
#include "golden_mutants/whole.hpp"

namespace sr::testing {

/// Those of pictures of codes.
std::vector<Recipe> unforeseen_photos();
std::vector<Recipe> unforeseen_interfaces();

} // namespace sr::testing
