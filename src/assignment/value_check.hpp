#pragma once
// Checks of values and of samples: against the reference, another expression (a law), a bound or a density.
#include "assignment/evaluation.hpp"
#include "assignment/manifest.hpp"
#include "image/image.hpp"

#include <optional>
#include <string>

namespace sr::assignment {

/// A mistake with a name.
struct Named {
    std::string name; // "pi_missing"
    std::string text; // "your result is the reference × π"
};

struct Finding {
    bool passed = false;
    bool is_implemented = true;
    std::string got, expected; // where they are furthest apart
    std::string at;            // the inputs there
    std::string message;       // what is wrong; empty if it passed
    std::optional<Named> diagnosis;
    std::optional<image::Image> picture, reference; // of an image check
};

/// "0.3183", "(0.1, 0.2, 0.3)", "true": the components that a type has.
std::string text_of(glm::dvec4 value, const std::string& type);

/// The teacher's hint for a finding that failed: for its diagnosis, else the check's own. May be empty.
std::string hint_for(const Task& task, const Check& check, const Finding& finding);

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

/// Directions that `check.value` draws from its input `u`, against the density `check.other` of the direction
/// `w` [1/sr]. Needs a current context. @throws ShaderError
Finding check_samples(const Assignment& assignment, const Parameters& parameters, const Check& check,
                      const Codes& codes);

/// How the root mean square of `check.value` - `check.other` over the inputs and 256 values of `seed` falls
/// with `count`: the slope of its logarithm. Needs a current context. @throws ShaderError
Finding check_slope(const Assignment& assignment, const Parameters& parameters, const Check& check,
                    const Codes& codes);

} // namespace sr::assignment
