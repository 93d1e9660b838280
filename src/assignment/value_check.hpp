#pragma once
// Checks of values and of samples: against the reference, another expression (a law), a bound or a density.
#include "assignment/evaluation.hpp"
#include "assignment/manifest.hpp"
#include "image/image.hpp"

#include <optional>
#include <string>

namespace sr::assignment {

/// A mistake that a check recognised.
struct Named {
    std::string name; // "pi_missing"
    std::string text; // "your result is the reference × π"
};

struct Finding {
    bool passed = false;
    bool is_implemented = true;
    std::string got, expected; // where the two differ most
    std::string at;            // the inputs there
    std::string message;       // what is wrong; empty if it passed
    std::optional<Named> diagnosis;
    std::optional<image::Image> picture, reference; // of an image check
};

/// Formats the components of a type: "0.3183", "(0.1, 0.2, 0.3)", "true".
std::string text_of(glm::dvec4 value, const std::string& type);

/// The teacher's hint for a failed finding: that of its diagnosis, or the check's own. May be empty.
std::string hint_for(const Task& task, const Check& check, const Finding& finding);

/// The values that a check compares.
struct Compared {
    Values got;
    std::vector<glm::dvec4> expected;
    std::vector<glm::dvec4> tolerance; // of each component
};

/// Evaluates both sides of a check. Needs a current context.
/// @throws ShaderError for the code; Error if a value of the reference is not finite
Compared compare_values(ReferenceValues& known, const Assignment& assignment, const Parameters& parameters,
                        const Check& check, const Codes& codes, const Inputs& inputs);

/// Evaluates the reference: at the inputs, and, unless they are averaged, at inputs moved by their last bits.
std::vector<Values> reference_values(ReferenceValues& known, const Assignment& assignment,
                                     const Parameters& parameters, const Check& check, const Inputs& inputs);

/// Evaluates a typical mistake. @return absent if one of its loops was stopped
std::optional<Values> mistaken_values(ReferenceValues& known, const Assignment& assignment,
                                      const Parameters& parameters, const Task& task, const Variant& mistake,
                                      const Check& check, const Inputs& inputs);

/// Compares the values within the tolerance.
Finding judge(const Check& check, const Compared& compared, const Inputs& inputs);

/// Finds the mistake of the task that gives the same values, or else a simple relation to the expected values
/// (a factor, zero, not finite). @param first name of the variant to try first. @return absent if none fits
std::optional<Named> diagnose(ReferenceValues& known, const Assignment& assignment,
                              const Parameters& parameters, const Task& task, const Check& check,
                              const Compared& compared, const Inputs& inputs, const std::string& first);

/// Tests (χ²) the directions that `check.value` samples from its input `u` against the density `check.other`
/// of the direction `w` [1/sr]. Needs a current context. @throws ShaderError
Finding check_samples(const Assignment& assignment, const Parameters& parameters, const Check& check,
                      const Codes& codes);

/// Measures how the root mean square of `check.value` - `check.other` over the inputs and 256 values of
/// `seed` falls with `count`: the slope in a log-log plot. Needs a current context. @throws ShaderError
Finding check_slope(const Assignment& assignment, const Parameters& parameters, const Check& check,
                    const Codes& codes);

} // namespace sr::assignment
