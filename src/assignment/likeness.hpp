#pragma once
// Pairs of submissions that are alike, to be looked at by a person. Fingerprints are those of the Python
// package copydetect (Schleimer, Wilkerson and Aiken 2003, "Winnowing").
#include "assignment/class_folder.hpp"
#include "assignment/manifest.hpp"

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace sr::assignment {

/// The code of a submission, without what the template has around it.
struct ComparedCode {
    std::string key, name; // class_folder.hpp
    std::string text;
};

/// A stretch of a text: [first, second), in bytes.
using Stretch = std::pair<std::size_t, std::size_t>;

/// Two submissions that are alike.
struct AlikePair {
    std::size_t a = 0, b = 0;            // of Likeness::codes
    double share_a = 0.0, share_b = 0.0; // of each code that the other has, too
    std::vector<Stretch> common_a, common_b;
};

struct Likeness {
    std::string assignment;
    double least = 0.0;
    std::vector<ComparedCode> codes;
    std::vector<AlikePair> pairs;     // the most alike first
    std::vector<std::string> remarks; // one line each: submissions that were left out, and why
};

struct LikenessOptions {
    std::filesystem::path submissions; // class_folder.hpp
    std::string python = "python3";    // that has the package
    double least = 0.5;                // the larger share of a pair that is listed
    std::size_t max_pairs = 50;
    double time_limit = 600.0; // [s]
    std::stop_token stop;
};

/// Compares the submissions of a class two by two, without the lines of the template. Names of variables,
/// comments and blanks do not count. @return absent if it was stopped
/// @throws Error if the folder is none, or the package is not installed: then with the command that installs
/// it
std::optional<Likeness> likeness_of(const Assignment& assignment, const LikenessOptions& options);

/// One page that needs nothing from outside: the pairs, each with its code side by side.
std::string likeness_html(const Likeness& likeness);

} // namespace sr::assignment
