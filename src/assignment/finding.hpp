#pragma once
// What a check found, and numbers as people read them.
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

} // namespace sr::assignment
