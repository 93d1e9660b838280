#pragma once
// Check of a submission in child processes: a shader that hangs or kills the driver costs its own task. The
// proof of an assignment: the reference gets full marks, the empty version none, each typical mistake its
// name, each other solution full marks.
#include "assignment/manifest.hpp"
#include "assignment/submission.hpp"

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sr::assignment {

struct CheckOptions {
    std::filesystem::path program; // steradian, whose `assignment mark` the children run
    double time_limit = 20.0;      // [s] of one task
    bool keeps_pictures = false;   // in the result of image checks, for reports
    std::function<void(const nlohmann::ordered_json& task)>
        on_task;                      // called as soon as a task is marked; may be empty
    std::function<bool()> is_stopped; // asked often; once true, the check ends. Empty: never
};

/// The sum of all tasks (mark.hpp); absent if `is_stopped` ended the check.
/// @throws Error if the submission has no label, or the assignment itself is at fault
std::optional<nlohmann::ordered_json> checked(const std::filesystem::path& submission,
                                              const CheckOptions& options);

/// What a child does: each task's result becomes a line of `results` as soon as it is there. @throws Error
void mark_tasks(const std::filesystem::path& submission, const std::vector<std::string>& tasks,
                const std::filesystem::path& results, bool keeps_pictures);

/// One submission that was tried, and what came of it.
struct Proof {
    std::string task; // empty: all tasks
    std::string name; // "reference", "empty", or the variant's
    std::string must; // "100 %", "0 %, not implemented", "fewer points and its name"
    std::string got;
    bool holds = false;
};

/// Needs a current context. @throws Error where the assignment is at fault
std::vector<Proof> proofs_of(const Assignment& assignment);

/// Fewer mistakes or solutions than an assignment is expected to list, one line a task; empty if there are
/// enough.
std::vector<std::string> shortages(const Assignment& assignment);

} // namespace sr::assignment
