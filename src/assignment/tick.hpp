#pragma once
// Oral examination of a submission (a tick): its marks, its code, and questions whose answers are computed.
#include "assignment/check.hpp"

#include <iosfwd>

namespace sr::assignment {

/// Asks for the examination of a submission. @return the marks (mark.hpp) with "seed", "code" (the lines that
/// differ most from the template), "questions" and "missing" (one line for each question that could not be
/// made); absent if it was stopped. `options.grading` says which assignment it is; the children are confined
/// as those of a teacher's check are.
/// @throws Error as check_submission() does
std::optional<nlohmann::ordered_json> examine(const std::filesystem::path& submission,
                                              const CheckOptions& options, const std::string& seed);

/// Does the work of a child: writes {"code": …} and four times {"question": …} or {"missing": …}, a line
/// each. Questions are about the code of `tasks`, which have marks. An empty seed is the student's id. Needs
/// a current context.
void write_questions(const Assignment& assignment, const Submission& submission, const std::string& student,
                     const std::vector<std::string>& tasks, const std::string& seed, std::ostream& stream);

/// One page for the examiner, to print on one sheet of A4. It needs nothing from outside.
std::string tick_html(const nlohmann::ordered_json& examination);

} // namespace sr::assignment
