#include "assignment/evaluation.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::assignment {
namespace {

constexpr float mark = 0x1p127f; // shaders/assignment/value.frag

/// Blank lines before a text, so that its own first line has the number that it has in its file.
std::string from_line(int line, const std::string& text) {
    return std::string(static_cast<std::size_t>(std::max(0, line - 1)), '\n') + text;
}

std::string asked_glsl(const Assignment& assignment, const Expression& expression,
                       std::span<const Input> columns) {
    std::string text = "// The expression of a check.\n";
    for (const auto& [name, contents] : assignment.files) text += fmt::format("#include \"{}\"\n", name);
    text += fmt::format("vec4 asked() {{\n{}    {} value = {};\n", declarations(columns), expression.type,
                        expression.text);
    const int count = components_of(expression.type);
    text += fmt::format(
        "    return vec4({}{});\n}}\n", count == 1 ? "float(value)" : "value",
        std::array{"", ", 0.0, 0.0, 0.0", ", 0.0, 0.0", ", 0.0", ""}[static_cast<std::size_t>(count)]);
    return text;
}

} // namespace

int components_of(const std::string& type) { return type.starts_with("vec") ? type.back() - '0' : 1; }

bool is_not_implemented(vec4 value) { return value.w == mark && value.x == mark; }

std::vector<glsl::Root> shader_path(const Assignment& assignment, const Parameters& parameters,
                                    const Codes& codes) {
    std::vector<glsl::Root> path;
    std::vector<std::string> names;
    for (const auto& [region, code] : codes) {
        names.push_back(region);
        path.push_back(
            glsl::Root::single(code.place, included_name(region), from_line(code.line, code.text)));
    }
    glsl::Files files{{"parameters.glsl", parameters_glsl(assignment, parameters)}};
    for (const auto& [name, text] : assignment.files)
        files[name] = with_includes(text, assignment.place_of(name), names);
    path.push_back(glsl::Root::memory((assignment.folder / "shaders").string(), std::move(files)));
    if (std::filesystem::is_directory(assignment.folder / "overlay"))
        path.push_back(glsl::Root::folder(assignment.folder / "overlay"));
    path.push_back(glsl::embedded());
    return path;
}

std::vector<vec4> evaluate_rows(const std::vector<glsl::Root>& path, const Assignment& assignment,
                                const Expression& expression, const Inputs& inputs) {
    std::vector<glsl::Root> whole{glsl::Root::memory(
        "check", {{"assignment/asked.glsl", asked_glsl(assignment, expression, inputs.columns)}})};
    whole.insert(whole.end(), path.begin(), path.end());
    return render::ShaderEvaluator(whole, "assignment/value.frag").evaluate(inputs.rows);
}

Values evaluate(const std::vector<glsl::Root>& path, const Assignment& assignment,
                const Expression& expression, const Inputs& inputs) {
    const std::vector<vec4> rows = evaluate_rows(path, assignment, expression, inputs);
    Values values;
    values.means.assign(rows.size() / inputs.group, glm::dvec4(0.0));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (is_not_implemented(rows[i])) values.is_implemented = false;
        values.means[i / inputs.group] += glm::dvec4(rows[i]) / static_cast<double>(inputs.group);
    }
    return values;
}

} // namespace sr::assignment
