#include "assignment/evaluation.hpp"

#include "core/error.hpp"
#include "glsl/untrusted.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>
#include <optional>
#include <random>

namespace sr::assignment {
namespace {

using Kind = Input::Kind;

/// The offset of each column in a row of twelve floats.
std::vector<int> offsets_of(std::span<const Input> columns) {
    std::vector<int> offsets;
    int next = 0;
    for (const Input& column : columns) {
        offsets.push_back(next);
        next += column.size();
    }
    require(next <= 12, "a row of inputs has at most twelve numbers");
    return offsets;
}

float& part(render::Row& row, int i) { return row[static_cast<std::size_t>(i / 4)][i % 4]; }
float part(const render::Row& row, int i) { return row[static_cast<std::size_t>(i / 4)][i % 4]; }

/// `count` numbers of [0, 1), one in each of as many intervals, in any order.
std::vector<double> stratified(int count, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> numbers;
    for (int i = 0; i < count; ++i) numbers.push_back((i + unit(random)) / count);
    std::ranges::shuffle(numbers, random);
    return numbers;
}

double between(const Input& column, double u) {
    if (column.is_log) return column.low * std::pow(column.high / column.low, u);
    return column.low + u * (column.high - column.low);
}

/// A direction whose cosine with n is z.
vec3 around(vec3 n, float z, float phi) {
    const vec3 side = std::abs(n.x) < 0.6f ? vec3(1.0f, 0.0f, 0.0f) : vec3(0.0f, 1.0f, 0.0f);
    const vec3 t = glm::normalize(glm::cross(n, side)), b = glm::cross(n, t);
    const float s = std::sqrt(std::max(0.0f, 1.0f - z * z));
    return glm::normalize(s * std::cos(phi) * t + s * std::sin(phi) * b + z * n);
}

/// Writes the column's value for u into a row.
void put(const Input& column, int offset, vec3 n, const std::array<double, 3>& u, render::Row& row) {
    const auto number = [&](std::size_t i) { return static_cast<float>(between(column, u[i])); };
    vec3 value(0.0f);
    const auto phi = static_cast<float>(u[1]) * 2.0f * pi;
    switch (column.kind) {
    case Kind::number: value.x = number(0); break;
    case Kind::integer:
        value.x =
            std::min(std::floor(static_cast<float>(column.low + u[0] * (column.high - column.low + 1.0))),
                     static_cast<float>(column.high));
        break;
    case Kind::list: {
        const auto size = column.values.size();
        value.x = static_cast<float>(
            column.values[std::min(static_cast<std::size_t>(u[0] * static_cast<double>(size)), size - 1)]);
        break;
    }
    case Kind::color:
    case Kind::box: value = vec3(number(0), number(1), number(2)); break;
    case Kind::sphere:
        value = around(vec3(0.0f, 0.0f, 1.0f), static_cast<float>(2.0 * u[0] - 1.0), phi);
        break;
    case Kind::hemisphere: value = around(n, number(0), phi); break;
    case Kind::square: value = vec3(u[0], u[1], 0.0); break;
    }
    for (int i = 0; i < column.size(); ++i) part(row, offset + i) = value[i];
}

/// The points that a row averages over: on a grid, one at random in each cell.
std::vector<std::array<double, 3>> averaged_points(const Input& column, int count, std::mt19937& random) {
    const bool is_flat = column.size() == 1;
    const int side = is_flat ? count : std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count))));
    std::uniform_real_distribution<double> unit(0.0, 1.0 - 1e-7);
    std::vector<std::array<double, 3>> points;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < (is_flat ? 1 : side); ++j)
            points.push_back(
                {(i + unit(random)) / side, (j + unit(random)) / (is_flat ? 1 : side), unit(random)});
    return points;
}

} // namespace

Inputs inputs_of(std::vector<Input> columns, int rows, const std::string& mean_over, int mean_count,
                 unsigned int seed) {
    std::mt19937 random(seed);
    Inputs inputs{std::move(columns), {}, 1, {}};
    inputs.identity = fmt::format("{} {} {} {}", rows, mean_over, mean_count, seed);
    for (const Input& c : inputs.columns)
        inputs.identity += fmt::format(" {} {} {} {} {} {} {}", c.name, static_cast<int>(c.kind), c.low,
                                       c.high, c.is_log, fmt::join(c.values, ","), c.around);
    const std::vector<int> offsets = offsets_of(inputs.columns);
    std::vector<render::Row> outer(static_cast<std::size_t>(rows));
    const auto index_of = [&](const std::string& name) {
        return static_cast<std::size_t>(std::ranges::find(inputs.columns, name, &Input::name)
                                        - inputs.columns.begin());
    };
    const auto normal_of = [&](const Input& column, const render::Row& row) {
        if (column.around.empty()) return vec3(0.0f, 0.0f, 1.0f);
        const int at = offsets[index_of(column.around)];
        return vec3(part(row, at), part(row, at + 1), part(row, at + 2));
    };
    for (std::size_t c = 0; c < inputs.columns.size(); ++c) {
        const Input& column = inputs.columns[c];
        std::array<std::vector<double>, 3> u{stratified(rows, random), stratified(rows, random),
                                             stratified(rows, random)};
        const bool has_ends =
            column.kind == Kind::number || column.kind == Kind::integer || column.kind == Kind::list;
        if (has_ends && rows > 8) { // a row of its own for each column's end
            const std::size_t at = 2 * c % static_cast<std::size_t>(rows - 1);
            u[0][at] = 0.0;
            u[0][at + 1] = 1.0;
        }
        for (std::size_t r = 0; r < outer.size(); ++r)
            put(column, offsets[c], normal_of(column, outer[r]), {u[0][r], u[1][r], u[2][r]}, outer[r]);
    }
    if (mean_over.empty()) {
        inputs.rows = std::move(outer);
        return inputs;
    }
    const std::size_t c = index_of(mean_over);
    const auto points = averaged_points(inputs.columns[c], mean_count, random);
    inputs.group = points.size();
    for (const render::Row& row : outer)
        for (const auto& u : points) {
            inputs.rows.push_back(row);
            put(inputs.columns[c], offsets[c], normal_of(inputs.columns[c], row), u, inputs.rows.back());
        }
    return inputs;
}

Inputs nudged(const Inputs& inputs) {
    Inputs result = inputs;
    result.identity += " moved";
    const std::vector<int> offsets = offsets_of(inputs.columns);
    std::mt19937 random(2);
    std::uniform_int_distribution<int> way(0, 3);
    for (render::Row& row : result.rows)
        for (std::size_t c = 0; c < inputs.columns.size(); ++c)
            for (int i = 0; i < inputs.columns[c].size() && inputs.columns[c].kind != Kind::integer; ++i) {
                const int w = way(random);
                float& value = part(row, offsets[c] + i);
                value *= 1.0f + static_cast<float>((w < 2 ? 1 : -1) * (w % 2 + 1)) * 0x1p-23f;
            }
    return result;
}

std::string declarations(std::span<const Input> columns) {
    const std::vector<int> offsets = offsets_of(columns);
    std::string text;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        std::vector<std::string> parts;
        for (int i = offsets[c]; i < offsets[c] + columns[c].size(); ++i)
            parts.push_back(fmt::format("row_part({})[{}]", i / 4, i % 4));
        text += fmt::format("    {0} {1} = {0}({2});\n", columns[c].type(), columns[c].name,
                            fmt::join(parts, ", "));
    }
    return text;
}

std::string describe(const Inputs& inputs, std::size_t row, const std::string& without) {
    const std::vector<int> offsets = offsets_of(inputs.columns);
    std::vector<std::string> words;
    for (std::size_t c = 0; c < inputs.columns.size(); ++c) {
        const Input& column = inputs.columns[c];
        if (column.name == without) continue;
        const auto value = [&](int i) {
            return fmt::format("{:.4g}", part(inputs.rows[row], offsets[c] + i));
        };
        std::vector<std::string> parts;
        for (int i = 0; i < column.size(); ++i) parts.push_back(value(i));
        words.push_back(column.size() == 1 ? fmt::format("{} {}", column.name, parts[0])
                                           : fmt::format("{} ({})", column.name, fmt::join(parts, ", ")));
    }
    return fmt::format("{}", fmt::join(words, ", "));
}

namespace {

constexpr float mark = 0x1p127f; // shaders/assignment/value.frag

/// Blank lines before a text, so that its own first line has the number that it has in its file.
std::string from_line(int line, const std::string& text) {
    return std::string(static_cast<std::size_t>(std::max(0, line - 1)), '\n') + text;
}

/// The words that untrusted code may have here, since the reference has them.
std::vector<std::string> permitted_words(const Assignment& assignment, const std::string& wanted) {
    std::vector<std::string> permitted;
    for (const auto& [name, text] : assignment.files)
        for (const Region& region : regions_of(text, assignment.place_of(name)))
            for (const char* word : {"discard", "gl_FragDepth"})
                if (region.name == wanted && without_comments(region.text).find(word) != std::string::npos)
                    permitted.emplace_back(word);
    return permitted;
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
        path.push_back(glsl::Root::single(code.place, included_name(region), from_line(code.line, code.text))
                           .untrusted(permitted_words(assignment, region)));
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

namespace {

render::ShaderEvaluator evaluator_of(const std::vector<glsl::Root>& path, const Assignment& assignment,
                                     const Expression& expression, std::span<const Input> columns) {
    std::vector<glsl::Root> whole{glsl::Root::memory(
        "check", {{"assignment/asked.glsl", asked_glsl(assignment, expression, columns)}})};
    whole.insert(whole.end(), path.begin(), path.end());
    return {whole, "assignment/value.frag"};
}

Values averaged(const std::vector<vec4>& rows, const Inputs& inputs) {
    Values values;
    values.means.assign(rows.size() / inputs.group, glm::dvec4(0.0));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (is_not_implemented(rows[i])) values.is_implemented = false;
        values.means[i / inputs.group] += glm::dvec4(rows[i]) / static_cast<double>(inputs.group);
    }
    return values;
}

std::vector<double> packed(const Values& values) {
    std::vector<double> numbers{values.is_implemented ? 1.0 : 0.0};
    for (const glm::dvec4& mean : values.means)
        for (int i = 0; i < 4; ++i) numbers.push_back(mean[i]);
    return numbers;
}

Values unpacked(const std::vector<double>& numbers) {
    Values values;
    values.is_implemented = numbers[0] != 0.0;
    for (std::size_t i = 1; i + 3 < numbers.size(); i += 4)
        values.means.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]);
    return values;
}

} // namespace

std::vector<vec4> evaluate_rows(const std::vector<glsl::Root>& path, const Assignment& assignment,
                                const Expression& expression, const Inputs& inputs) {
    return evaluator_of(path, assignment, expression, inputs.columns).evaluate(inputs.rows);
}

Values evaluate(const std::vector<glsl::Root>& path, const Assignment& assignment,
                const Expression& expression, const Inputs& inputs) {
    return averaged(evaluate_rows(path, assignment, expression, inputs), inputs);
}

std::vector<std::string> identity_of(const Assignment& assignment, const Parameters& parameters,
                                     const Codes& codes) {
    std::vector<std::string> parts{parameters.empty() ? "" : parameters_glsl(assignment, parameters)};
    for (const auto& [region, code] : codes) parts.insert(parts.end(), {region, code.text});
    return parts;
}

std::vector<Values> evaluate_reference(ReferenceValues& known, const Assignment& assignment,
                                       const Parameters& parameters, const Codes& codes,
                                       const Expression& expression, const std::vector<Inputs>& tables) {
    std::optional<render::ShaderEvaluator> evaluator; // made once, if at all
    std::vector<Values> result;
    for (const Inputs& inputs : tables) {
        std::vector<std::string> parts = identity_of(assignment, parameters, codes);
        parts.insert(parts.end(), {expression.text, expression.type, inputs.identity});
        const std::string key = key_of(parts);
        const std::vector<double>* numbers = known.find(key);
        if (!numbers) try {
                if (!evaluator)
                    evaluator.emplace(evaluator_of(shader_path(assignment, parameters, codes), assignment,
                                                   expression, inputs.columns));
                numbers = &known.add(key, packed(averaged(evaluator->evaluate(inputs.rows), inputs)));
            } catch (const glsl::LoopError&) {
                numbers = &known.add(key, {});
            }
        if (numbers->empty()) throw glsl::LoopError({codes.empty() ? "" : codes.begin()->second.place});
        result.push_back(unpacked(*numbers));
    }
    return result;
}

} // namespace sr::assignment
