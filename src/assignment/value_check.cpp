#include "assignment/value_check.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace sr::assignment {
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

/// How far a value is beyond what is allowed: 1 is just allowed.
double excess(Relation relation, double got, double expected, double tolerance) {
    if (got == expected) return 0.0;
    if (!std::isfinite(got)) return infinity;
    const double over = got - expected;
    const double counted = relation == Relation::at_most    ? over
                           : relation == Relation::at_least ? -over
                                                            : std::abs(over);
    return counted > 0.0 ? counted / tolerance : 0.0;
}

/// How far off a row is: its worst component, and the same for what the row's values have in common.
double excess(Relation relation, const Compared& c, std::size_t row, int count) {
    double worst = 0.0;
    for (int i = 0; i < count; ++i)
        worst =
            std::max(worst, excess(relation, c.got.means[row][i], c.expected[row][i], c.tolerance[row][i]));
    return worst;
}

/// How far values are from those of a mistake, in units of the check's nearness. Infinite where they are not
/// the mistake's.
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
            // What rounding does to the reference it may do to a mistake as well.
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

Compared compare_values(const Assignment& assignment, const Parameters& parameters, const Check& check,
                        const Codes& codes, const Inputs& inputs) {
    const Expression value{check.value, check.type};
    const auto theirs = shader_path(assignment, parameters, codes);
    const auto ours = shader_path(assignment, parameters, {});
    const int count = components_of(check.type);
    Compared compared;
    compared.got = evaluate(theirs, assignment, value, inputs);
    const Values reference = evaluate(ours, assignment, value, inputs);
    compared.expected = check.relation == Relation::reference
                            ? reference.means
                            : evaluate(theirs, assignment, {check.other, check.type}, inputs).means;
    compared.tolerance = tolerances_around(compared.expected, check.nearness, count);
    if (inputs.group > 1) return compared; // a mean over many values does not follow the last bits of one
    const Values moved = evaluate(ours, assignment, value, nudged(inputs));
    for (std::size_t r = 0; r < compared.tolerance.size(); ++r)
        for (int i = 0; i < count; ++i)
            if (const double change = std::abs(moved.means[r][i] - reference.means[r][i]);
                std::isfinite(change))
                compared.tolerance[r][i] += 8.0 * change;
    return compared;
}

Finding judged(const Check& check, const Compared& compared, const Inputs& inputs) {
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
    finding.at = described(inputs, worst * inputs.group, check.mean_over);
    if (!finding.passed)
        finding.message = fmt::format("wrong for {} of {} inputs", failing, compared.expected.size());
    return finding;
}

std::optional<Named> diagnosed(const Assignment& assignment, const Parameters& parameters, const Task& task,
                               const Check& check, const Compared& compared, const Inputs& inputs,
                               const std::string& first) {
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
        const auto path = shader_path(assignment, parameters,
                                      {{task.id, {task.variants_place, mistake->line, mistake->text}}});
        const Values values = evaluate(path, assignment, {check.value, check.type}, inputs);
        const double d = distance(compared.got.means, values.means, compared, check.nearness, count);
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

} // namespace sr::assignment
