#pragma once
// An assignment as its teacher writes it: assignment.json with the files beside it (README.md has the form).
#include "assignment/regions.hpp"
#include "core/math.hpp"
#include "glsl/root.hpp"
#include "render/visibility/visibility_backend.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sr::assignment {

/// A column of a check's table of inputs: a GLSL variable and the values that it takes.
struct Input {
    enum class Kind {
        number,     // from low to high, evenly or by ratio
        list,       // each of `values`
        integer,    // whole numbers from low to high
        color,      // three numbers from low to high
        box,        // a point, each coordinate from low to high
        sphere,     // a unit direction
        hemisphere, // a unit direction w with dot(w, n) from low to high; n is the input `around`, or +z
        square,     // a point of [0, 1)²
    };
    std::string name;
    Kind kind = Kind::number;
    double low = 0.0, high = 1.0;
    bool is_log = false;
    std::vector<double> values;
    std::string around;

    /// The number of floats that it takes in a row, and its GLSL type.
    int size() const;
    const char* type() const;
};

/// Tolerance of a value: |got - expected| ≤ relative |expected| + absolute · (the largest |expected|) +
/// the change of the expected value when the inputs change in their last bits.
struct Nearness {
    double relative = 1e-4;
    double absolute = 1e-6;
};

struct Check {
    enum class Kind { value, samples, slope, image };
    enum class Relation { reference, equals, at_most, at_least };

    std::string name;
    bool is_hidden = false; // students learn whether it passed, and nothing else
    unsigned int seed = 1;  // of its inputs
    Kind kind = Kind::value;
    double points = 1.0;
    std::string hint;  // for a failure without a diagnosis
    std::string unit;  // of the value
    std::string value; // a GLSL expression over the inputs
    std::string type = "float";
    Relation relation = Relation::reference;
    std::string other; // the expression that the value is compared with; empty with Relation::reference
    std::vector<Input> inputs;
    int rows = 256;
    std::string mean_over; // the input over which the value is averaged; empty: none
    int mean_count = 4096; // how many values of it a row averages
    Nearness nearness;

    // samples: directions that `value` draws from the input `square`, against the density `other` of the
    // direction w. slope: how the error of `value` against `other` falls with `count`.
    std::vector<int> counts;
    double slope = -0.5, slope_within = 0.1;

    // image
    std::string scene, camera = "0";
    int width = 128, height = 96, samples = 16;
    std::string shader = "forward.frag";
    render::Visibility visibility = render::Visibility::ray;
    std::vector<std::string> tolerances; // as `steradian compare` takes them
};

struct Task {
    std::string id; // "A3.2", the name of its region
    std::string title;
    bool is_extra = false;              // its points come on top of 100 %
    std::string file;                   // that has its region
    std::vector<std::string> functions; // that the student writes
    std::vector<Check> checks;
    std::map<std::string, std::string>
        hints; // by the name of a mistake, or of a diagnosis of values and images
    std::vector<Variant> variants;
    std::string variants_place;

    double points() const;
};

/// A number that differs from student to student.
struct Parameter {
    std::string name;
    std::string unit;
    std::string about;
    std::vector<double> values; // one of these
    double low = 0.0, high = 1.0;
    int decimals = 2; // to which it is rounded
};

struct Assignment {
    std::filesystem::path folder;
    std::string id; // "a3-brdf", the folder's name
    std::string title;
    std::string summary;
    std::string scene; // for the live view; empty: none
    glsl::Files files; // the reference's, by name
    std::vector<Parameter> parameters;
    std::vector<Task> tasks;

    std::string place_of(const std::string& file) const;
    const Task& task(const std::string& id) const;
    double points() const; // of the tasks that are not extra
};

/// Reads FOLDER/assignment.json and the files that it names. @throws Error, with line and column where the
/// JSON is at fault
Assignment load(const std::filesystem::path& folder);

/// Adds the hidden checks of FOLDER/hidden.json: {"seed": N, "tasks": {"A3.2": [checks as in
/// assignment.json]}}. Their scenes lie in FOLDER. @throws Error likewise
void add_hidden_checks(Assignment& assignment, const std::filesystem::path& folder);

} // namespace sr::assignment
