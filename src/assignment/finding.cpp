#include "assignment/finding.hpp"

#include "assignment/evaluation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sr::assignment {

std::string text_of(glm::dvec4 value, const std::string& type) {
    if (type == "bool") return value.x != 0.0 ? "true" : "false";
    std::vector<std::string> parts;
    for (int i = 0; i < components_of(type); ++i) parts.push_back(fmt::format("{:.4g}", value[i]));
    return parts.size() == 1 ? parts.front() : fmt::format("({})", fmt::join(parts, ", "));
}

std::string hint_for(const Task& task, const Check& check, const Finding& finding) {
    if (!finding.is_implemented) return {};
    if (finding.diagnosis) {
        const auto found = task.hints.find(finding.diagnosis->name);
        return found != task.hints.end() ? found->second : check.hint;
    }
    return check.hint;
}

} // namespace sr::assignment
