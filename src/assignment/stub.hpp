#pragma once
// The student's version of a region: the functions that they write, with bodies that say they are not
// written.
#include <string>
#include <vector>

namespace sr::assignment {

/// The region's text with, for each of `functions`, the comments right above it, its signature and the body
/// `return not_implemented();` (with the swizzle of its type). All else is left out. The body is what stands
/// behind `// stub:` in the region instead, where there is such a line; lines that begin with `// keep:` stay
/// without that word.
/// `line` is that of the text's first line in `place`. @throws Error if a function is not defined there
std::string stub_of(const std::string& text, const std::vector<std::string>& functions,
                    const std::string& place, int line);

/// The text with every comment and every literal of the preprocessor blanked, so that braces can be counted.
/// Places stay.
std::string without_comments(const std::string& text);

/// The line, counted from 1, of the first bracket that has no partner, and the bracket; 0 if all have one.
struct LoneBracket {
    int line = 0;
    char bracket = ' ';
};
LoneBracket lone_bracket(const std::string& text);

} // namespace sr::assignment
