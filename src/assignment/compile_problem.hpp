#pragma once
// Compile errors of a student's code, at the student's line, with hints for beginners.
#include "assignment/evaluation.hpp"
#include "gl/program.hpp"

#include <string>
#include <vector>

namespace sr::assignment {

struct Problem {
    std::string place; // the file
    int line = 0;
    int column = 0;     // 0: unknown
    std::string text;   // the driver's message
    std::string source; // the line itself; empty where it is not the student's
    std::string hint;   // empty: none
};

/// At most five problems, those in the student's files first. If the driver blames only the code around the
/// region, one problem that blames the task's region.
std::vector<Problem> problems_of(const gl::ShaderError& error, const std::string& task, const Codes& codes);

/// A likely mistake of a beginner, given the driver's words and the line; empty if nothing is known.
std::string hint_for_complaint(const std::string& complaint, const std::string& source);

} // namespace sr::assignment
