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

/// Replaces the code of each named region by an #include of `region/NAME.glsl`.
std::string with_includes(const std::string& text, const std::string& place,
                          const std::vector<std::string>& names);

/// The file name in the includes of with_includes.
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

/// Makes the student's version of a region: for each of `functions` the comments directly above it, its
/// signature, and the body `return not_implemented();` (with the swizzle of its type), or the text after
/// `// stub:` in the region. Lines that begin with `// keep:` stay, without that word. All else is removed.
/// @param line number of the text's first line in `place`. @throws Error if a function is not defined there
std::string stub_of(const std::string& text, const std::vector<std::string>& functions,
                    const std::string& place, int line);

/// Blanks comments and preprocessor literals, so that brackets can be counted. Positions stay.
std::string without_comments(const std::string& text);

/// The line, counted from 1, of the first bracket that has no partner, and the bracket; 0 if all have one.
struct LoneBracket {
    int line = 0;
    char bracket = ' ';
};
LoneBracket lone_bracket(const std::string& text);

} // namespace sr::assignment
