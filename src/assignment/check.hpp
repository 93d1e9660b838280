#pragma once
// Check of a submission in child processes: a shader that hangs or kills the driver costs its own task. The
// proof of an assignment: the reference gets full marks, the empty version none, each typical mistake its
// name, each other solution full marks.
#include "assignment/manifest.hpp"
#include "assignment/submission.hpp"

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sr::assignment {

/// A file of values of the reference (reference_values.hpp).
struct ReferenceFile {
    std::filesystem::path file; // empty: none
    std::string digest;         // its SHA-256. A file of another is not read
};

/// Additional options of a teacher's check.
struct Grading {
    std::filesystem::path assignment;              // its folder, whatever the submission's label names
    std::filesystem::path hidden;                  // folder of hidden checks; empty: none
    std::string student;                           // id that the platform knows; empty: the label's
    std::uint64_t memory = std::uint64_t{2} << 30; // [bytes] beyond what the driver has at the start
    ReferenceFile values;                          // which need not be computed for each submission
};

struct CheckOptions {
    std::filesystem::path program;  // steradian, whose `assignment mark` the children run
    double time_limit = 20.0;       // [s] of one task
    bool keeps_pictures = false;    // in the result of image checks, for reports
    std::optional<Grading> grading; // by a teacher; absent: a student's own check
    std::function<void(const nlohmann::ordered_json& task)>
        on_task;          // called as soon as a task is marked; may be empty
    std::stop_token stop; // ends the check
};

/// Checks a submission. @return the sum of all tasks (mark.hpp); absent if it was stopped.
/// With `grading` the children are confined (confinement.hpp), a submission that cannot be read gets no
/// points, and the sum has "refused" (lines of what was not taken), "lacking" (protections that the system
/// does not have), "label" and "label_student" (the assignment and the student that the submission names).
/// @throws Error if the submission has no label, or the assignment itself is at fault
std::optional<nlohmann::ordered_json> check_submission(const std::filesystem::path& submission,
                                                       const CheckOptions& options);

/// The arguments of a child process.
struct MarkRequest {
    std::filesystem::path submission;
    std::filesystem::path results; // a file
    std::vector<std::string> tasks;
    bool keeps_pictures = false;
    std::optional<Grading> grading;
    int processor_seconds = 600;            // with `grading`
    std::optional<std::string> tick_seed{}; // asks questions (tick.hpp) instead of marking; with `grading`
};

/// The words of `steradian` that make a child do this, and the work itself: writes a line of `results` once a
/// task is marked; with `grading`, before them, {"intake": …}. @throws Error
std::vector<std::string> words_of(const MarkRequest& request);
void mark_tasks(const MarkRequest& request);

/// The words of `steradian` that make a child compute values of the reference, and the work itself: writes
/// them to a file.
/// @throws Error
std::vector<std::string> words_of_references(const Grading& grading, const std::filesystem::path& file,
                                             bool mistakes);
void compute_references(const Grading& grading, const std::filesystem::path& file, bool mistakes);

/// One submission that was tried, and its result.
struct Proof {
    std::string task; // empty: all tasks
    std::string name; // "reference", "empty", or the variant's
    std::string must; // "100 %", "0 %, not implemented", "fewer points and its name"
    std::string got;
    bool holds = false;
};

/// Proves an assignment. Needs a current context. @throws Error if the assignment is at fault
std::vector<Proof> proofs_of(const Assignment& assignment);

/// The tasks that list too few mistakes or solutions, one line each.
std::vector<std::string> shortages(const Assignment& assignment);

} // namespace sr::assignment
