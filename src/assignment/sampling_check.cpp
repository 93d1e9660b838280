#include "assignment/sampling_check.hpp"

#include "core/chi_squared.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sr::assignment {
namespace {

constexpr int rings = 16, sectors = 12; // cells of the sphere, of equal solid angle
constexpr int asked_side =
    384; // squared: where the density is asked for; whole numbers of points fall into cells
constexpr int drawn_side = 128;         // squared: how many directions are drawn
constexpr double most_deviations = 5.0; // of the statistic above its mean
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

/// How many directions of a row fall into each cell.
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
    return inputs_of(columns, check.rows);
}

} // namespace

Finding check_samples(const Assignment& assignment, const Parameters& parameters, const Check& check,
                      const Codes& codes) {
    const auto path = shader_path(assignment, parameters, codes);
    const Inputs fixed = fixed_inputs(check, "u");
    std::vector<Input> drawing = fixed.columns, asking = fixed.columns;
    drawing.push_back(column("u", Input::Kind::square));
    asking.push_back(column("w", Input::Kind::sphere));
    const Inputs draws = inputs_of(drawing, check.rows, "u", drawn_side * drawn_side);
    const Inputs asks = inputs_of(asking, check.rows, "w", asked_side * asked_side);
    const std::vector<vec4> directions = evaluate_rows(path, assignment, {check.value, "vec3"}, draws);
    const std::vector<vec4> densities = evaluate_rows(path, assignment, {check.other, "float"}, asks);
    const std::vector<vec4> asked = evaluate_rows(path, assignment, {"w", "vec3"}, asks);
    Finding finding;
    finding.passed = true;
    finding.expected = fmt::format("≤ {:g}", most_deviations);
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
        const double statistic = row.is_unit ? chi_squared_excess(expected, row.counts).value_or(1e9) : 1e9;
        if (!(statistic <= worst)) {
            worst = statistic;
            finding.at = described(draws, r * draws.group, "u");
            finding.got = fmt::format("{:.3g}", statistic);
            finding.message = !row.is_unit ? "some directions are not of length 1"
                              : std::abs(integral - 1.0) > 0.05
                                  ? fmt::format("the density integrates to {:.3g}, not to 1", integral)
                                  : "directions are not as dense as the density says";
        }
    }
    finding.passed = finding.is_implemented && worst <= most_deviations;
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
        const Inputs inputs = inputs_of(columns, slope_seeds);
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
