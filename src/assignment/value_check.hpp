#pragma once
// Values over a table of inputs: against the reference, against another expression (a law), against a bound.
#include "assignment/evaluation.hpp"
#include "assignment/finding.hpp"

namespace sr::assignment {

/// What a check compares.
struct Compared {
    Values got;
    std::vector<glm::dvec4> expected;
    std::vector<glm::dvec4> tolerance; // of each component
};

/// Needs a current context. @throws ShaderError for the code; Error where the reference's own value is no
/// number
Compared compare_values(const Assignment& assignment, const Parameters& parameters, const Check& check,
                        const Codes& codes, const Inputs& inputs);

Finding judged(const Check& check, const Compared& compared, const Inputs& inputs);

/// The mistake of the task's that gives just these values; else the plain relation that they have to the
/// expected ones (a factor, zero, no numbers); absent if there is none. `first` is the variant to try first,
/// by name.
std::optional<Named> diagnosed(const Assignment& assignment, const Parameters& parameters, const Task& task,
                               const Check& check, const Compared& compared, const Inputs& inputs,
                               const std::string& first);

} // namespace sr::assignment
