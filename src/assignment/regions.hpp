#pragma once
// Regions of a GLSL file: the lines that belong to one task of an assignment.
//
//     // begin solution A3.2 …       in the reference;  // begin A3.2 …  in a student's file
//     float D_ggx(float cos_h, float alpha) { … }
//     // end …
#include <string>
#include <string_view>
#include <vector>

namespace sr::assignment {

/// The region `helpers` holds functions that several tasks may call; it is always the student's.
inline constexpr std::string_view helpers_region = "helpers";

struct Region {
    std::string name;
    int begin_line = 0; // of the marker "// begin", counted from 1; the code begins on the next line
    int end_line = 0;   // of the marker "// end"
    std::string text;   // the lines between the markers, each with its end

    bool operator==(const Region&) const = default;
};

/// The regions of a file, in their order. `place` is what errors call the file.
/// A name is `helpers` or a task's: A3.2. A bare "// end" ends a solution alone.
/// @throws Error with the line for a region that has no end, an end without its begin, a region in a region,
/// and two regions of one name.
std::vector<Region> regions_of(const std::string& text, const std::string& place);

/// The file with an #include of `region/NAME.glsl` in the place of the code of each of the named regions.
std::string with_includes(const std::string& text, const std::string& place,
                          const std::vector<std::string>& names);

/// What includes of with_includes name.
std::string included_name(std::string_view region);

/// A variant of a region: another right solution, or a typical mistake.
struct Variant {
    std::string name;
    bool is_mistake = false;
    int line = 0;     // where its code begins, counted from 1
    std::string text; // what stands in the region
};

/// The sections of a variants file. Each begins with a line `// mistake NAME` or `// solution NAME`.
/// @throws Error with the line for code before the first section and for a name that is used twice
std::vector<Variant> variants_of(const std::string& text, const std::string& place);

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
