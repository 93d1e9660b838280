#pragma once
// Lengths of functions and macros with all that they call, which drivers write out in full.
#include "glsl/tokens.hpp"

#include <map>
#include <string>

namespace sr::glsl {

struct Macro {
    bool has_parameters = false;
    std::vector<Token> body;
};
using Macros = std::map<std::string_view, Macro>;

/// @throws Error for a function that calls itself, directly or not, and for a text that becomes longer than
/// 100,000 tokens once macros and calls are written out
void require_short_calls(const std::vector<Token>& tokens, const Macros& macros, const std::string& place);

} // namespace sr::glsl
