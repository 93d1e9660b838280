#pragma once
// Changes of one line of GLSL that a typical mistake would make: a factor dropped, wi and wo exchanged, …
#include "assignment/evaluation.hpp"

#include <string>
#include <vector>

namespace sr::assignment {

struct CodeChange {
    std::string name; // of its kind: "remove_max", "drop_factor", "swap_wi_wo", …
    int line = 0;     // in the file, counted from 1
    std::string from; // the line as it is, without blanks around it
    std::string to;   // the line that replaces it, likewise
    std::string part; // what is dropped or replaced: "max(0.0, dot(n, wi))", "* pi"

    bool operator==(const CodeChange&) const = default;
};

/// Lists the changes of each line, in the order of the lines. Comments, directives and blank lines have none.
/// Some do not compile, since a factor may be what makes a float a vec3.
std::vector<CodeChange> code_changes(const Code& code);

/// Makes one of the changes of `code_changes(code)`.
Code changed(const Code& code, const CodeChange& change);

} // namespace sr::assignment
