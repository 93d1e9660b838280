#include "assignment/self_test.hpp"

#include "assignment/mark.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sr::assignment {
namespace {

using nlohmann::ordered_json;

constexpr int fewest_mistakes = 6, fewest_solutions = 2; // of a task

/// What a task's result comes to in one line.
std::string summary(const ordered_json& task) {
    std::string names;
    for (const ordered_json& check : task["checks"])
        if (!check["diagnosis"].is_null() && names.find(check["diagnosis"]["name"]) == std::string::npos)
            names += (names.empty() ? " " : ", ") + check["diagnosis"]["name"].get<std::string>();
    for (const ordered_json& problem : task["problems"]) names += " " + problem["text"].get<std::string>();
    return fmt::format("{:.0f} %{}", 100.0 * task["points"].get<double>() / task["of"].get<double>(), names);
}

Proof proof_of(const Task& task, const Variant& variant, Marker& marker) {
    Submission submission;
    submission.codes[task.id] = {task.variants_place, variant.line, variant.text};
    const ordered_json result = marker.mark(task, submission);
    const bool is_whole = result["status"] == "passed";
    Proof proof{task.id, variant.name, variant.is_mistake ? "loses points, named" : "100 %", summary(result),
                is_whole};
    if (variant.is_mistake) {
        bool is_named = false;
        for (const ordered_json& check : result["checks"])
            if (!check["diagnosis"].is_null()) {
                is_named = check["diagnosis"]["name"] == variant.name;
                break;
            }
        proof.holds = !is_whole && result["problems"].empty() && is_named;
    }
    return proof;
}

} // namespace

std::vector<Proof> proofs_of(const Assignment& assignment) {
    std::vector<Proof> proofs;
    Marker marker(assignment, "reference");
    const Submission empty = empty_submission(assignment);
    Submission reference;
    for (const auto& [name, text] : assignment.files)
        for (const Region& region : regions_of(text, assignment.place_of(name)))
            reference.codes[region.name] = {assignment.place_of(name), region.begin_line + 1, region.text};
    for (const Task& task : assignment.tasks) {
        const ordered_json whole = marker.mark(task, reference), none = marker.mark(task, empty);
        proofs.push_back({task.id, "reference", "100 %", summary(whole), whole["status"] == "passed"});
        proofs.push_back({task.id, "empty", "0 %, not implemented",
                          summary(none) + ", " + none["status"].get<std::string>(),
                          none["status"] == "not implemented"});
        for (const Variant& variant : task.variants) proofs.push_back(proof_of(task, variant, marker));
    }
    return proofs;
}

std::vector<std::string> shortages(const Assignment& assignment) {
    std::vector<std::string> lines;
    for (const Task& task : assignment.tasks) {
        const auto mistakes = std::ranges::count(task.variants, true, &Variant::is_mistake);
        const auto solutions = std::ssize(task.variants) - mistakes;
        if (mistakes < fewest_mistakes || solutions < fewest_solutions)
            lines.push_back(fmt::format("{}: {} mistakes and {} other solutions, expected at least {} and {}",
                                        task.id, mistakes, solutions, fewest_mistakes, fewest_solutions));
    }
    return lines;
}

} // namespace sr::assignment
