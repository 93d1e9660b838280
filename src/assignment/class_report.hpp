#pragma once
// Results of submissions in the forms of spreadsheets, browsers, Gradescope, Moodle's VPL and JUnit.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace sr::assignment {

/// One line a student, with the points of each task. RFC 4180. A cell that a spreadsheet would take for a
/// formula begins with an apostrophe.
std::string csv_of(const std::vector<nlohmann::ordered_json>& results);

/// A test suite for each student, a test case for each task.
std::string junit_of(const std::vector<nlohmann::ordered_json>& results);

/// One page that needs nothing from outside: how the points of each task are distributed, the commonest
/// mistakes, and the students with links to students/KEY.html.
std::string overview_html(const std::vector<nlohmann::ordered_json>& results);

/// Gradescope's results.json ("Autograder Specifications"): a test for each task, with the pictures of checks
/// that failed where the result has them, 512 KiB at most. A result whose tasks are not all marked is a
/// partial one.
nlohmann::ordered_json gradescope_of(const nlohmann::ordered_json& result);

/// The output of vpl_evaluate.sh of Moodle's Virtual Programming Lab: comments, and a grade out of
/// `grade_max`.
std::string vpl_of(const nlohmann::ordered_json& result, double grade_max);

} // namespace sr::assignment
