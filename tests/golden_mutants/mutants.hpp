#pragma once
// Right and wrong versions of a picture, and what a comparator must say of each.
#include "compare/compare.hpp"

#include <string>
#include <vector>

namespace sr::testing {

/// The diagnosis of a mutant of which only the verdict matters.
inline const std::string any_diagnosis = "*";

struct Mutant {
    std::string name;
    image::Image test;
    image::Image reference;
    bool passes = false;   // what the verdict must be
    std::string diagnosis; // its name; empty: none may be claimed; or any_diagnosis
    std::string layer;     // of the diagnosis
    compare::CompareOptions options;
};

/// Differences that are no mistake: rounding, another driver, noise at its floor, a few stray pixels.
std::vector<Mutant> harmless();
/// Values that are wrong in a way that has a name: factors, curves, channels.
std::vector<Mutant> wrong_values();
/// Pixels at the wrong place.
std::vector<Mutant> wrong_places();
/// Lights missing, doubled, weakened; shadows missing.
std::vector<Mutant> wrong_lights();
/// Holes, fireflies, regions, noise, and what has no name.
std::vector<Mutant> wrong_otherwise();

/// All of the above.
std::vector<Mutant> mutants();

} // namespace sr::testing
