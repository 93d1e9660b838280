#pragma once
// Check of a submission in child processes: a shader that hangs or kills the driver costs its own task. The
// proof of an assignment: the reference gets full marks, the empty version none, each typical mistake its
// name, each other solution full marks.
#include "assignment/manifest.hpp"
#include "assignment/submission.hpp"

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sr::assignment {

struct CheckOptions {
    std::filesystem::path program; // steradian, whose `assignment mark` the children run
    double time_limit = 20.0;      // [s] of one task
    bool keeps_pictures = false;   // in the result of image checks, for reports
    std::function<void(const nlohmann::ordered_json& task)>
        on_task;          // called as soon as a task is marked; may be empty
    std::stop_token stop; // ends the check
};

/// Checks a submission. @return the sum of all tasks (mark.hpp); absent if it was stopped
/// @throws Error if the submission has no label, or the assignment itself is at fault
std::optional<nlohmann::ordered_json> check_submission(const std::filesystem::path& submission,
                                                       const CheckOptions& options);

/// The work of a child process: writes each task's result as a line of `results` once it is marked.
/// @throws Error
void mark_tasks(const std::filesystem::path& submission, const std::vector<std::string>& tasks,
                const std::filesystem::path& results, bool keeps_pictures);

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
