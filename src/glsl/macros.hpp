#pragma once
// Macros of a GLSL text, written out as the preprocessor of a driver does.
#include "glsl/tokens.hpp"

#include <map>
#include <string>
#include <vector>

namespace sr::glsl {

struct Macro {
    bool has_parameters = false;
    std::vector<std::string_view> parameters;
    std::vector<Token> body;
};
using Macros = std::map<std::string_view, Macro>;

/// The number of tokens that a text may have once macros, or macros and calls, are written out.
inline constexpr int max_written_tokens = 100'000;

/// Writes out the macros in code. Each token has the line of the macro's use. `steps` counts the work over
/// several calls. @throws Error for a macro that is used within itself or without its arguments, and for a
/// text that becomes too long
std::vector<Token> written_out(std::vector<Token> code, const Macros& macros, const std::string& place,
                               int& steps);

} // namespace sr::glsl
