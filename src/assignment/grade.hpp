#pragma once
// Grading of a class: each submission in a child process of its own, several at a time, resumable.
#include "assignment/check.hpp"
#include "assignment/class_folder.hpp"

namespace sr::assignment {

struct GradeOptions {
    std::filesystem::path submissions; // class_folder.hpp
    std::filesystem::path output;      // a folder, which may hold the results of a run that was ended
    int jobs = 1;
    CheckOptions check; // with its `grading`; `on_task` and `keeps_pictures` are this library's own
    std::function<void(std::size_t done, std::size_t all, const nlohmann::ordered_json& result)>
        on_done; // one at a time; also for what an earlier run has graded
    std::function<void(const std::string&)> on_remark; // lines for a person
};

/// A submission without a result, and what its result will have as its fingerprint.
struct UngradedSubmission {
    HandedIn submission;
    std::string fingerprint;
};

/// The submissions of `options` that have no result in `output`/results, or that have changed since.
/// @throws Error
std::vector<UngradedSubmission> ungraded(const GradeOptions& options);

/// Grades one submission, and writes results/KEY.json, students/KEY.html and gradescope/KEY.json to a folder.
/// @return its result; absent if `check.stop` ended it. @throws Error
std::optional<nlohmann::ordered_json> grade_one(const UngradedSubmission& one, CheckOptions check,
                                                const std::filesystem::path& output);

/// Grades the submissions that have no result in `output`/results, or that have changed since, as have the
/// assignment and the hidden checks. Then writes marks.csv, overview.html, junit.xml, and a page for each
/// student. A result is written whole once its submission is graded. @return the results in the order of the
/// submissions; absent if `check.stop` ended it, which leaves the results so far
/// @throws Error, for example if another process grades into the same folder
std::optional<std::vector<nlohmann::ordered_json>> grade_class(const GradeOptions& options);

} // namespace sr::assignment
