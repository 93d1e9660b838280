#include "compare/tolerance.hpp"

#include "core/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace sr::compare {
namespace {

struct Named {
    Measure measure;
    std::string_view name;
    bool takes_quantile;
};

constexpr std::array measures{Named{Measure::rel, "rel", true},
                              Named{Measure::abs, "abs", true},
                              Named{Measure::z, "z", true},
                              Named{Measure::flip, "flip", true},
                              Named{Measure::hdr_flip, "hdr_flip", true},
                              Named{Measure::mean_rel, "mean_rel", false},
                              Named{Measure::mean_abs, "mean_abs", false},
                              Named{Measure::rmse, "rmse", false},
                              Named{Measure::rel_mse, "rel_mse", false},
                              Named{Measure::energy, "energy", false},
                              Named{Measure::ssim, "ssim", false},
                              Named{Measure::density, "density", false}};

[[noreturn]] void refuse(std::string_view expression, std::string_view why) {
    throw Error(
        fmt::format("'{}' is no tolerance: {}", expression, why),
        "write NAME=LIMIT, NAME=LIMIT@PERCENT% or NAME=LIMIT@edges, such as rel=0.02@99.5% or flip=0.03");
}

std::optional<double> parse_number(std::string_view text) {
    double value = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (failure != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) || value < 0.0)
        return std::nullopt;
    return value;
}

const Named& named(std::string_view name, std::string_view expression) {
    const auto found = std::ranges::find(measures, name, &Named::name);
    if (found != measures.end()) return *found;
    std::string names;
    for (const Named& known : measures) names += fmt::format("{}{}", names.empty() ? "" : ", ", known.name);
    refuse(expression, fmt::format("'{}' is none of {}", name, names));
}

double parse_limit(std::string_view text, Measure measure, std::string_view expression) {
    if (measure == Measure::z && text == "auto") return 0.0;
    const auto limit = parse_number(text);
    if (!limit) refuse(expression, fmt::format("'{}' is not a number from 0 up", text));
    if (measure == Measure::z && *limit == 0.0) refuse(expression, "no two noisy images keep z=0");
    if (measure == Measure::ssim && *limit > 1.0) refuse(expression, "an SSIM is at most 1");
    return *limit;
}

double parse_quantile(std::string_view text, std::string_view expression) {
    if (!text.ends_with('%')) refuse(expression, "a quantile ends in %, such as @99.5%");
    const auto percent = parse_number(text.substr(0, text.size() - 1));
    if (!percent || *percent <= 0.0 || *percent > 100.0)
        refuse(expression, fmt::format("'{}' is not between 0 and 100 %", text));
    return *percent / 100.0;
}

} // namespace

Tolerance parse_tolerance(std::string_view expression) {
    const auto equals = expression.find('=');
    if (equals == std::string_view::npos) refuse(expression, "it has no =");
    const Named& measure = named(expression.substr(0, equals), expression);
    const std::string_view value = expression.substr(equals + 1);
    const auto at = value.find('@');

    Tolerance tolerance;
    tolerance.measure = measure.measure;
    tolerance.text = expression;
    tolerance.limit = parse_limit(value.substr(0, at), measure.measure, expression);
    // FLIP is usually stated as a mean; the others of its kind have means of their own.
    const bool is_flip = measure.measure == Measure::flip || measure.measure == Measure::hdr_flip;
    tolerance.by_pixel = measure.takes_quantile && (!is_flip || at != std::string_view::npos);
    if (at != std::string_view::npos) {
        if (!measure.takes_quantile)
            refuse(expression, fmt::format("{} is one number for the image", measure.name));
        tolerance.forgives_edges = value.substr(at + 1) == "edges";
        if (tolerance.forgives_edges && is_flip) refuse(expression, "FLIP forgives edges by itself");
        if (!tolerance.forgives_edges) tolerance.quantile = parse_quantile(value.substr(at + 1), expression);
    }
    return tolerance;
}

std::vector<Tolerance> parse_tolerances(std::span<const std::string> expressions) {
    std::vector<Tolerance> tolerances;
    for (const std::string& expression : expressions) tolerances.push_back(parse_tolerance(expression));
    return tolerances;
}

std::string_view name_of(Measure measure) {
    return std::ranges::find(measures, measure, &Named::measure)->name;
}

} // namespace sr::compare
