#pragma once
// Marks of a submission, task by task: as JSON, as a table, as a page.
#include "assignment/pictures.hpp"
#include "assignment/submission.hpp"
#include "golden/page.hpp"

#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace sr::assignment {

class Marker {
public:
    /// Needs a current context during its lifetime. With `keeps_pictures`, image checks have "pictures" for
    /// reports. `known`: values of this assignment that need not be computed again.
    Marker(const Assignment& assignment, const std::string& student, bool keeps_pictures = false,
           ReferenceValues known = {})
        : assignment_(assignment),
          keeps_pictures_(keeps_pictures),
          parameters_(parameters_of(assignment, student)),
          known_(std::move(known)),
          pictures_(assignment_, parameters_, known_) {}

    Marker(const Marker&) = delete;
    Marker& operator=(const Marker&) = delete;

    /// Computes what checks compare a submission with: the reference's values and pictures, and with
    /// `mistakes` those of typical mistakes. @throws Error
    const ReferenceValues& compute_references(bool mistakes);

    /// Marks a task (assets/assignment_result.schema.json): the student's region, the reference for all
    /// others.
    /// @throws Error if the assignment itself is at fault
    nlohmann::ordered_json mark(const Task& task, const Submission& submission);

private:
    nlohmann::ordered_json mark_hidden(const Task& task, const Check& check, const Codes& codes);
    nlohmann::ordered_json mark_check(const Task& task, const Check& check, const Codes& codes);
    Finding found(const Task& task, const Check& check, const Codes& codes);

    const Assignment& assignment_;
    bool keeps_pictures_;
    Parameters parameters_;
    ReferenceValues known_;
    Pictures pictures_;
    std::string last_mistake_; // of the task that is being marked
};

/// Sums the tasks, extra points included: {"assignment", "student", "points", "of", "percent", "tasks"}.
nlohmann::ordered_json sum_of(const Assignment& assignment, const std::string& student,
                              const nlohmann::ordered_json& tasks);

/// The same without pictures, as in assets/assignment_result.schema.json.
nlohmann::ordered_json without_pictures(nlohmann::ordered_json result);

/// The result of a task whose check ended early.
nlohmann::ordered_json ended_early(const Task& task, const std::string& why);

/// Formats a result as a table: task, check, verdict, got, expected, unit, diagnosis and hint.
std::string table_of(const nlohmann::ordered_json& result);

/// The style and script of report/.
golden::ReportPage marks_page();

/// One HTML file that needs nothing from outside (golden/page.hpp), with the pictures of the result. Where no
/// script may run it shows a table.
std::string report_html(const nlohmann::ordered_json& result);

} // namespace sr::assignment
