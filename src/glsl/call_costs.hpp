#pragma once
// Costs of functions with all that they call, which drivers write out in full.
#include "glsl/tokens.hpp"

#include <string>
#include <vector>

namespace sr::glsl {

/// Checks code whose macros are written out. @throws Error for a function that calls itself, directly or not;
/// for code that becomes longer than 100,000 tokens, or has arrays of more than 64 KiB, once calls are
/// written out
void require_low_costs(const std::vector<Token>& code, const std::string& place);

} // namespace sr::glsl
