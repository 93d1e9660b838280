#pragma once
// Tokens of a GLSL text, directives among them. Comments are no tokens.
#include <string>
#include <string_view>
#include <vector>

namespace sr::glsl {

struct Token {
    enum class Kind { word, number, sign, name }; // name: what stands in quotation marks, with them
    Kind kind = Kind::sign;
    std::string_view text;
    std::size_t at = 0;        // of its first byte
    int line = 1;              // counted from 1
    bool is_directive = false; // stands on a line that begins with #
    bool begins_line = false;  // of a directive: it is the #
};

/// Returns the tokens of a text, whose line breaks are "\n". A sign is one byte: "&&" is two tokens.
/// @throws Error for a byte that no GLSL has outside comments, a comment that never ends, a backslash at the
/// end of a line, and text that is not UTF-8 or has a NUL byte
std::vector<Token> tokenize(std::string_view text, const std::string& place);

/// Returns the index behind the bracket that closes the one at `open`, or `end` if none does.
std::size_t behind_bracket(const std::vector<Token>& tokens, std::size_t open, std::size_t end);

} // namespace sr::glsl
