#include "assignment/value_check.hpp"

#include "assignment/evaluation.hpp"
#include "core/error.hpp"
#include "core/math.hpp"
#include "glsl/untrusted.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <numbers>

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

namespace {

using Relation = Check::Relation;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest finite magnitude in a column of values.
double largest(const std::vector<glm::dvec4>& values, int count) {
    double most = 0.0;
    for (const glm::dvec4& value : values)
        for (int i = 0; i < count; ++i)
            if (std::isfinite(value[i])) most = std::max(most, std::abs(value[i]));
    return most;
}

std::vector<glm::dvec4> tolerances_around(const std::vector<glm::dvec4>& expected, const Nearness& nearness,
                                          int count) {
    const double floor = nearness.absolute * largest(expected, count);
    std::vector<glm::dvec4> tolerances;
    for (const glm::dvec4& value : expected)
        tolerances.push_back(nearness.relative * glm::abs(value) + floor
                             + std::numeric_limits<double>::min());
    return tolerances;
}

/// The error of a value over its tolerance: 1 just passes.
double excess(Relation relation, double got, double expected, double tolerance) {
    if (got == expected && (std::isfinite(got) || relation == Relation::reference)) return 0.0;
    // Of a law both sides may be the student's.
    if (!std::isfinite(got) || !std::isfinite(expected) || !std::isfinite(tolerance)) return infinity;
    const double over = got - expected;
    const double counted = relation == Relation::at_most    ? over
                           : relation == Relation::at_least ? -over
                                                            : std::abs(over);
    return counted > 0.0 ? counted / tolerance : 0.0;
}

/// The error of a row over its tolerance: that of its worst component, and of what its values have in common.
double excess(Relation relation, const Compared& c, std::size_t row, int count) {
    double worst = 0.0;
    for (int i = 0; i < count; ++i)
        worst =
            std::max(worst, excess(relation, c.got.means[row][i], c.expected[row][i], c.tolerance[row][i]));
    return worst;
}

/// The distance of values to those of a mistake, in units of the tolerance. Infinite if they are not the
/// mistake's.
double distance(const std::vector<glm::dvec4>& got, const std::vector<glm::dvec4>& mistaken,
                const Compared& compared, const Nearness& nearness, int count) {
    const double floor = nearness.absolute * largest(mistaken, count) + std::numeric_limits<double>::min();
    double furthest = 0.0;
    for (std::size_t r = 0; r < got.size(); ++r)
        for (int i = 0; i < count; ++i) {
            const double x = got[r][i], y = mistaken[r][i];
            if (x == y || (std::isnan(x) && std::isnan(y))) continue;
            if (!std::isfinite(x) || !std::isfinite(y)) return infinity;
            const double near = nearness.relative * std::abs(y) + floor;
            // Rounding may change a mistake as much as the reference.
            if (!(std::abs(x - y) <= std::max(near, compared.tolerance[r][i]))) return infinity;
            furthest = std::max(furthest, std::abs(x - y) / near);
        }
    return furthest;
}

std::optional<Named> plain_relation(const Compared& compared, int count) {
    double ratio = 0.0;
    bool is_ratio = false, is_zero = true;
    for (std::size_t r = 0; r < compared.got.means.size(); ++r)
        for (int i = 0; i < count; ++i) {
            const double got = compared.got.means[r][i], expected = compared.expected[r][i];
            if (!std::isfinite(got))
                return Named{"not_a_number", "your result is not a finite number for some inputs"};
            is_zero = is_zero && got == 0.0;
            if (std::abs(expected) <= compared.tolerance[r][i]) continue;
            if (!is_ratio) ratio = got / expected;
            is_ratio = true;
            if (std::abs(got / expected - ratio) > 1e-3 * std::abs(ratio)) ratio = std::nan("");
        }
    if (is_zero) return Named{"zero", "your result is 0 for every input"};
    if (!is_ratio || !std::isfinite(ratio) || ratio == 0.0) return std::nullopt;
    struct Factor {
        double value;
        const char* text;
    };
    constexpr double pi_ = std::numbers::pi;
    for (const auto& [value, text] : {Factor{pi_, "π"},
                                      {1.0 / pi_, "1/π"},
                                      {2.0 * pi_, "2π"},
                                      {0.5 / pi_, "1/(2π)"},
                                      {4.0 * pi_, "4π"},
                                      {0.25 / pi_, "1/(4π)"},
                                      {2.0, "2"},
                                      {0.5, "1/2"},
                                      {4.0, "4"},
                                      {0.25, "1/4"},
                                      {-1.0, "-1"},
                                      {180.0 / pi_, "180/π"},
                                      {pi_ / 180.0, "π/180"},
                                      {683.0, "683"},
                                      {1.0 / 683.0, "1/683"}})
        if (std::abs(ratio / value - 1.0) < 2e-3)
            return Named{"factor", fmt::format("your result is the expected one × {}", text)};
    return Named{"factor", fmt::format("your result is the expected one × {:.4g}", ratio)};
}

} // namespace

std::vector<Values> reference_values(ReferenceValues& known, const Assignment& assignment,
                                     const Parameters& parameters, const Check& check, const Inputs& inputs) {
    std::vector<Inputs> tables{inputs};
    if (inputs.group == 1) tables.push_back(nudged(inputs));
    return evaluate_reference(known, assignment, parameters, {}, {check.value, check.type}, tables);
}

std::optional<Values> mistaken_values(ReferenceValues& known, const Assignment& assignment,
                                      const Parameters& parameters, const Task& task, const Variant& mistake,
                                      const Check& check, const Inputs& inputs) {
    try {
        return evaluate_reference(known, assignment, parameters,
                                  {{task.id, {task.variants_place, mistake.line, mistake.text}}},
                                  {check.value, check.type}, {inputs})[0];
    } catch (const glsl::LoopError&) {
        return std::nullopt;
    }
}

Compared compare_values(ReferenceValues& known, const Assignment& assignment, const Parameters& parameters,
                        const Check& check, const Codes& codes, const Inputs& inputs) {
    const Expression value{check.value, check.type};
    const auto theirs = shader_path(assignment, parameters, codes);
    const int count = components_of(check.type);
    Compared compared;
    compared.got = evaluate(theirs, assignment, value, inputs);
    const bool needs_reference = check.relation == Check::Relation::reference || inputs.group == 1;
    std::vector<Values> ours;
    if (needs_reference) ours = reference_values(known, assignment, parameters, check, inputs);
    compared.expected = check.relation == Relation::reference
                            ? ours[0].means
                            : evaluate(theirs, assignment, {check.other, check.type}, inputs).means;
    compared.tolerance = tolerances_around(compared.expected, check.nearness, count);
    if (inputs.group > 1) return compared; // a mean over many values does not follow the last bits of one
    for (std::size_t r = 0; r < compared.tolerance.size(); ++r)
        for (int i = 0; i < count; ++i)
            if (const double change = std::abs(ours[1].means[r][i] - ours[0].means[r][i]);
                std::isfinite(change))
                compared.tolerance[r][i] += 8.0 * change;
    return compared;
}

Finding judge(const Check& check, const Compared& compared, const Inputs& inputs) {
    const int count = components_of(check.type);
    Finding finding;
    finding.is_implemented = compared.got.is_implemented;
    if (!finding.is_implemented) {
        finding.message = "not implemented";
        return finding;
    }
    std::size_t worst = 0, failing = 0;
    double most = -1.0;
    for (std::size_t r = 0; r < compared.expected.size(); ++r) {
        const double e = excess(check.relation, compared, r, count);
        if (e > 1.0) ++failing;
        // Of those that are not finite the first; else the furthest beyond what is allowed.
        if (e > most) {
            most = e;
            worst = r;
        }
    }
    finding.passed = failing == 0;
    finding.got = text_of(compared.got.means[worst], check.type);
    const char* sign = check.relation == Relation::at_most    ? "≤ "
                       : check.relation == Relation::at_least ? "≥ "
                                                              : "";
    finding.expected = sign + text_of(compared.expected[worst], check.type);
    finding.at = describe(inputs, worst * inputs.group, check.mean_over);
    if (!finding.passed)
        finding.message = fmt::format("wrong for {} of {} inputs", failing, compared.expected.size());
    return finding;
}

std::optional<Named> diagnose(ReferenceValues& known, const Assignment& assignment,
                              const Parameters& parameters, const Task& task, const Check& check,
                              const Compared& compared, const Inputs& inputs, const std::string& first) {
    const int count = components_of(check.type);
    std::vector<const Variant*> mistakes;
    for (const Variant& variant : task.variants)
        if (variant.is_mistake) mistakes.push_back(&variant);
    std::ranges::stable_partition(mistakes, [&](const Variant* v) { return v->name == first; });
    // Where the mistakes' values are small beside the right ones, several are within the tolerance: the
    // nearest one is named.
    const Variant* nearest = nullptr;
    double least = infinity;
    for (const Variant* mistake : mistakes) {
        const auto values = mistaken_values(known, assignment, parameters, task, *mistake, check, inputs);
        if (!values) continue;
        const double d = distance(compared.got.means, values->means, compared, check.nearness, count);
        if (d < least) {
            least = d;
            nearest = mistake;
        }
        if (d == 0.0) break;
    }
    if (nearest) return Named{nearest->name, task.hints.at(nearest->name)};
    return check.relation == Relation::reference || check.relation == Relation::equals
               ? plain_relation(compared, count)
               : std::nullopt;
}

namespace {

constexpr int rings = 16, sectors = 12; // cells of the sphere, of equal solid angle
constexpr int asked_side = 384; // squared: points of the density; each cell gets a whole number of them
constexpr int drawn_side = 128; // squared: how many directions are drawn
constexpr double max_deviations = 5.0; // of the statistic above its mean
constexpr int slope_seeds = 256;

Input column(const char* name, Input::Kind kind) {
    Input input;
    input.name = name;
    input.kind = kind;
    return input;
}

std::size_t cell_of(glm::dvec3 w) {
    const int ring = std::clamp(static_cast<int>((w.z + 1.0) * 0.5 * rings), 0, rings - 1);
    const double turn = std::atan2(w.y, w.x) / (2.0 * glm::pi<double>()) + 0.5;
    return static_cast<std::size_t>(ring * sectors
                                    + std::clamp(static_cast<int>(turn * sectors), 0, sectors - 1));
}

/// The number of directions of a row in each cell.
struct Drawn {
    std::vector<double> counts = std::vector<double>(rings * sectors, 0.0);
    bool is_implemented = true, is_unit = true;
};

Drawn drawn(const std::vector<vec4>& directions, std::size_t first, std::size_t count) {
    Drawn result;
    for (std::size_t i = first; i < first + count; ++i) {
        const glm::dvec3 w(directions[i]);
        result.is_implemented = result.is_implemented && !is_not_implemented(directions[i]);
        if (!(std::abs(glm::length(w) - 1.0) < 1e-3))
            result.is_unit = false;
        else
            result.counts[cell_of(w)] += 1.0;
    }
    return result;
}

/// The fixed columns of a check, with their rows.
Inputs fixed_inputs(const Check& check, const std::string& without) {
    std::vector<Input> columns;
    for (const Input& input : check.inputs)
        if (input.name != without) columns.push_back(input);
    return inputs_of(columns, check.rows, "", 1, check.seed);
}

} // namespace

Finding check_samples(const Assignment& assignment, const Parameters& parameters, const Check& check,
                      const Codes& codes) {
    const auto path = shader_path(assignment, parameters, codes);
    const Inputs fixed = fixed_inputs(check, "u");
    std::vector<Input> drawing = fixed.columns, asking = fixed.columns;
    drawing.push_back(column("u", Input::Kind::square));
    asking.push_back(column("w", Input::Kind::sphere));
    const Inputs draws = inputs_of(drawing, check.rows, "u", drawn_side * drawn_side, check.seed);
    const Inputs asks = inputs_of(asking, check.rows, "w", asked_side * asked_side, check.seed);
    const std::vector<vec4> directions = evaluate_rows(path, assignment, {check.value, "vec3"}, draws);
    const std::vector<vec4> densities = evaluate_rows(path, assignment, {check.other, "float"}, asks);
    const std::vector<vec4> asked = evaluate_rows(path, assignment, {"w", "vec3"}, asks);
    Finding finding;
    finding.passed = true;
    finding.expected = fmt::format("≤ {:g}", max_deviations);
    double worst = -1e9;
    for (std::size_t r = 0; r < static_cast<std::size_t>(check.rows); ++r) {
        const Drawn row = drawn(directions, r * draws.group, draws.group);
        std::vector<double> expected(rings * sectors, 0.0);
        double integral = 0.0;
        for (std::size_t i = r * asks.group; i < (r + 1) * asks.group; ++i) {
            finding.is_implemented = finding.is_implemented && !is_not_implemented(densities[i]);
            const double share = 4.0 * glm::pi<double>() * densities[i].x / static_cast<double>(asks.group);
            expected[cell_of(glm::dvec3(asked[i]))] += share * static_cast<double>(draws.group);
            integral += share;
        }
        finding.is_implemented = finding.is_implemented && row.is_implemented;
        const double excess = row.is_unit ? chi_squared_excess(expected, row.counts).value_or(1e9) : 1e9;
        const double statistic = std::isfinite(integral) && std::isfinite(excess) ? excess : 1e9;
        if (statistic > worst) {
            worst = statistic;
            finding.at = describe(draws, r * draws.group, "u");
            finding.got = fmt::format("{:.3g}", statistic);
            finding.message = !row.is_unit ? "some directions are not of length 1"
                              : !(std::abs(integral - 1.0) <= 0.05)
                                  ? fmt::format("the density integrates to {:.3g}, not to 1", integral)
                                  : "directions are not as dense as the density says";
        }
    }
    finding.passed = finding.is_implemented && worst <= max_deviations;
    if (finding.passed) finding.message.clear();
    if (!finding.is_implemented) finding.message = "not implemented";
    return finding;
}

Finding check_slope(const Assignment& assignment, const Parameters& parameters, const Check& check,
                    const Codes& codes) {
    const auto path = shader_path(assignment, parameters, codes);
    std::vector<double> x, y;
    Finding finding;
    for (const int count : check.counts) {
        Input counts = column("count", Input::Kind::list), seed = column("seed", Input::Kind::number);
        counts.kind = Input::Kind::integer;
        counts.low = counts.high = count;
        seed.low = 0.0;
        seed.high = 1.0;
        std::vector<Input> columns = fixed_inputs(check, "").columns;
        columns.push_back(counts);
        columns.push_back(seed);
        const Inputs inputs = inputs_of(columns, slope_seeds, "", 1, check.seed);
        const std::vector<vec4> got = evaluate_rows(path, assignment, {check.value, check.type}, inputs);
        const std::vector<vec4> exact = evaluate_rows(shader_path(assignment, parameters, {}), assignment,
                                                      {check.other, check.type}, inputs);
        double sum = 0.0;
        for (std::size_t i = 0; i < got.size(); ++i) {
            finding.is_implemented = finding.is_implemented && !is_not_implemented(got[i]);
            const double difference = static_cast<double>(got[i].x) - static_cast<double>(exact[i].x);
            sum += difference * difference;
        }
        x.push_back(std::log(static_cast<double>(count)));
        y.push_back(0.5 * std::log(sum / static_cast<double>(got.size())));
    }
    double mean_x = 0.0, mean_y = 0.0, xy = 0.0, xx = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / static_cast<double>(x.size());
        mean_y += y[i] / static_cast<double>(x.size());
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (x[i] - mean_x) * (y[i] - mean_y);
        xx += (x[i] - mean_x) * (x[i] - mean_x);
    }
    const double slope = xy / xx;
    finding.passed = finding.is_implemented && std::abs(slope - check.slope) <= check.slope_within;
    finding.got = fmt::format("{:.3f}", slope);
    finding.expected = fmt::format("{:g} ± {:g}", check.slope, check.slope_within);
    finding.at = fmt::format("counts {} to {}", check.counts.front(), check.counts.back());
    if (!finding.passed)
        finding.message = finding.is_implemented
                              ? "the error does not fall with the number of samples as it should"
                              : "not implemented";
    return finding;
}

} // namespace sr::assignment
