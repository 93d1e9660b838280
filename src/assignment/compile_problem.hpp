#pragma once
// What a driver has against a student's code, at their own line, with the words that help a beginner.
#include "assignment/evaluation.hpp"
#include "gl/program.hpp"

#include <string>
#include <vector>

namespace sr::assignment {

struct Problem {
    std::string place; // the file
    int line = 0;
    int column = 0;     // 0: unknown
    std::string text;   // the driver's words
    std::string source; // the line itself; empty where it is not the student's
    std::string hint;   // empty: none
};

/// At most five, those in the student's files first. Where the driver blames only what stands around the
/// code, one that blames the task's region.
std::vector<Problem> problems_of(const gl::ShaderError& error, const std::string& task, const Codes& codes);

/// What a beginner may have done that a driver complains of in these words, seen the line; empty: nothing
/// known.
std::string hint_for_complaint(const std::string& complaint, const std::string& source);

} // namespace sr::assignment
