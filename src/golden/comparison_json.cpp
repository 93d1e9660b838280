#include "golden/comparison_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

namespace sr::golden {
namespace {

using nlohmann::ordered_json;

/// JSON has no infinities.
ordered_json number(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0.0 ? "inf" : "-inf";
    return value;
}

ordered_json metrics_json(const Metrics& m) {
    ordered_json json{{"pixels", m.pixels},
                      {"nonfinite_test", m.nonfinite_test},
                      {"nonfinite_reference", m.nonfinite_reference}};
    const auto add = [&json](std::string_view name, double value) {
        if (!std::isnan(value)) json[std::string(name)] = number(value);
    };
    add("floor", m.floor);
    add("max_abs", m.max_abs);
    add("mean_abs", m.mean_abs);
    add("max_rel", m.max_rel);
    add("mean_rel", m.mean_rel);
    add("rmse", m.rmse);
    add("rel_mse", m.rel_mse);
    if (m.pixels > 0)
        json["energy_ratio"] = {number(m.energy_ratio[0]), number(m.energy_ratio[1]),
                                number(m.energy_ratio[2])};
    add("flip", m.flip);
    add("hdr_flip", m.hdr_flip);
    add("ssim", m.ssim);
    add("failing_fraction", m.failing_fraction);
    add("density", m.density);
    add("max_z", m.max_z);
    add("max_block_z", m.max_block_z);
    add("total_z", m.total_z);
    return json;
}

} // namespace

ordered_json json_of(const Comparison& comparison) {
    ordered_json verdicts = ordered_json::array();
    for (const Verdict& verdict : comparison.verdicts)
        verdicts.push_back({{"passed", verdict.passed}, {"line", verdict.line}});
    ordered_json diagnosis; // null
    if (comparison.diagnosis) {
        const Diagnosis& d = *comparison.diagnosis;
        diagnosis = {{"name", d.name}, {"statement", d.statement}, {"residual", number(d.residual)}};
        if (!d.layer.empty()) diagnosis["layer"] = d.layer;
    }
    return {{"passed", comparison.passed},
            {"verdicts", verdicts},
            {"metrics", metrics_json(comparison.metrics)},
            {"diagnosis", diagnosis}};
}

} // namespace sr::golden
