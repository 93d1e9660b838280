#include "compare/compare.hpp"

#include "compare/flip.hpp"
#include "core/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string_view>
#include <type_traits>
#include <variant>

namespace sr::compare {
namespace {

using image::Image;

constexpr const char* default_density = "density=0.25";

/// The given tolerances, or the default ones; with a limit on density if a share of the pixels may fail.
std::vector<Tolerance> tolerances_in_use(const CompareOptions& options) {
    std::vector<Tolerance> tolerances = options.tolerances;
    if (tolerances.empty())
        tolerances = default_tolerances(options.encoding, !options.noise.empty(), options.bits);
    const bool limits_density =
        std::ranges::any_of(tolerances, [](const Tolerance& t) { return t.measure == Measure::density; });
    const bool some_may_fail =
        std::ranges::any_of(tolerances, [](const Tolerance& t) { return t.quantile < 1.0; });
    if (some_may_fail && !limits_density) tolerances.push_back(parse_tolerance(default_density));
    return tolerances;
}

/// The tolerances on pixels, or the default ones: there is always an error map.
std::vector<Tolerance> pixel_tolerances(const std::vector<Tolerance>& tolerances,
                                        const CompareOptions& options) {
    if (std::ranges::any_of(tolerances, &Tolerance::by_pixel)) return tolerances;
    return default_tolerances(options.encoding, !options.noise.empty(), options.bits);
}

double mean_over(const Plane& plane, const AlignedImages& images) {
    double sum = 0.0;
    for (const std::size_t i : images.compared) sum += static_cast<double>(plane.values[i]);
    return sum / static_cast<double>(images.compared.size());
}

/// FLIP and SSIM: the visible difference.
void measure_appearance(const AlignedImages& images, const CompareOptions& options,
                        Measurements& measurements) {
    const bool is_light = options.encoding == Encoding::scene_referred;
    const DisplayedImages shown = display(images.test, images.reference, is_light);
    measurements.flip =
        flip(screen_light(shown.test), screen_light(shown.reference), options.pixels_per_degree);
    measurements.metrics.flip = mean_over(measurements.flip, images);
    measurements.metrics.ssim = ssim(luma(shown.test), luma(shown.reference));
    if (!is_light) return;
    const Exposures exposures = options.exposures ? *options.exposures : exposures_for(images.reference);
    measurements.hdr_flip = hdr_flip(images.test, images.reference, exposures, options.pixels_per_degree);
    measurements.metrics.hdr_flip = mean_over(measurements.hdr_flip, images);
}

Measurements measure(const AlignedImages& images, const CompareOptions& options) {
    Measurements measurements;
    measure_differences(images, measurements.metrics);
    if (images.compared.empty()) return measurements;
    measurements.abs = absolute_differences(images);
    measurements.rel = relative_differences(images, measurements.metrics.floor);
    if (!options.noise.empty()) {
        measurements.noise = score_noise(images, options.noise);
        measurements.metrics.max_z = std::ranges::max(measurements.noise->pixels);
        measurements.metrics.max_block_z = measurements.noise->max_block;
        measurements.metrics.total_z = measurements.noise->total;
    }
    measure_appearance(images, options, measurements);
    return measurements;
}

/// The error map of Comparison.
Image error_map(const AlignedImages& images, const PixelValues& errors) {
    Image map(images.reference.width, images.reference.height, 1);
    for (std::size_t i = 0; i < images.pixels.size(); ++i)
        map.pixels[i] = images.pixels[i] == PixelState::nonfinite ? std::nanf("") : -1.0f;
    for (std::size_t k = 0; k < errors.size(); ++k) map.pixels[images.compared[k]] = errors[k];
    return map;
}

Verdict judge_finite(const AlignedImages& images, bool nonfinite_is_allowed) {
    const std::size_t count = images.nonfinite_test + images.nonfinite_reference;
    return {count == 0 || nonfinite_is_allowed,
            fmt::format("finite pixels only: {} of the test and {} of the reference are not{}",
                        images.nonfinite_test, images.nonfinite_reference,
                        count > 0 && nonfinite_is_allowed ? ", which is allowed" : "")};
}

void judge(const AlignedImages& images, Measurements& measurements, const CompareOptions& options,
           Comparison& comparison) {
    comparison.verdicts.push_back(judge_finite(images, options.allow_nonfinite));
    if (images.compared.empty()) {
        comparison.verdicts.push_back({false, "something to compare: no pixel is finite in both images"});
        comparison.error = error_map(images, {});
        return;
    }
    const auto tolerances = tolerances_in_use(options);
    measurements.even_energy_ratio = energy_ratios(images, pixels_at_edges(images, measurements, tolerances));
    const PixelValues errors =
        errors_over_limits(images, measurements, pixel_tolerances(tolerances, options));
    std::vector<bool> fails;
    for (const float error : errors) fails.push_back(!(error <= 1.0f));
    measurements.metrics.failing_fraction =
        static_cast<double>(std::ranges::count(fails, true)) / static_cast<double>(fails.size());
    measurements.metrics.density = densest_window(images, fails);
    for (const Tolerance& tolerance : tolerances)
        comparison.verdicts.push_back(judge(tolerance, images, measurements));
    comparison.error = error_map(images, errors);
}

/// The limits on rel and abs, which are for any channel; the default ones if there are none.
std::vector<Tolerance> layer_tolerances(const CompareOptions& options) {
    std::vector<Tolerance> tolerances = tolerances_in_use(options);
    std::erase_if(tolerances,
                  [](const Tolerance& t) { return t.measure != Measure::rel && t.measure != Measure::abs; });
    return tolerances.empty() ? default_tolerances(options.encoding, false, options.bits) : tolerances;
}

/// Judges one of the reference's other layers, and adds its errors to the error map.
void judge_layer(const AlignedImages& images, const std::string& name, const CompareOptions& options,
                 Comparison& comparison) {
    const std::string prefix = name.empty() ? "other channels: " : fmt::format("layer {}: ", name);
    Verdict finite = judge_finite(images, options.allow_nonfinite);
    if (!finite.passed) comparison.verdicts.push_back({false, prefix + finite.line});
    if (images.compared.empty()) return;
    Measurements measurements;
    measurements.metrics.floor = relative_floor(images);
    measurements.abs = absolute_differences(images);
    measurements.rel = relative_differences(images, measurements.metrics.floor);
    std::vector<Tolerance> tolerances = layer_tolerances(options);
    std::erase_if(tolerances, [](const Tolerance& t) { return !t.by_pixel; });
    for (const Tolerance& tolerance : tolerances) {
        const Verdict verdict = judge(tolerance, images, measurements);
        if (!verdict.passed) comparison.verdicts.push_back({false, prefix + verdict.line});
    }
    const PixelValues errors = errors_over_limits(images, measurements, tolerances);
    for (std::size_t k = 0; k < errors.size(); ++k) {
        float& error = comparison.error.pixels[images.compared[k]];
        if (error >= 0.0f) error = std::max(error, errors[k]);
    }
}

/// Judges all channels of the reference but the picture's colours: none may be missing. Noise is known of the
/// picture alone: with it, other layers only must be there.
void judge_other_channels(const Image& test, const Image& reference, const CompareOptions& options,
                          Comparison& comparison) {
    std::string missing = lacks_alpha(test, reference, options.layer) ? "alpha" : "";
    std::size_t compared = 0, failing = comparison.verdicts.size();
    if (options.layer.empty())
        for (const OtherLayer& layer : other_layers(test, reference)) {
            const auto& wanted = options.other_layers;
            if (wanted && std::ranges::find(*wanted, layer.name) == wanted->end()) continue;
            for (const std::string& channel : layer.missing)
                missing += (missing.empty() ? "" : ", ") + channel;
            if (layer.reference.empty() || !options.noise.empty()) continue;
            judge_layer(align(test, reference, layer, options), layer.name, options, comparison);
            ++compared;
        }
    if (!missing.empty())
        comparison.verdicts.push_back({false, "all channels of the reference: the test lacks " + missing});
    else if (compared > 0 && failing == comparison.verdicts.size())
        comparison.verdicts.push_back(
            {true, fmt::format("other layers: {} of {} agree", compared, compared)});
}

} // namespace

std::vector<Tolerance> default_tolerances(Encoding encoding, bool noise_is_known, int bits) {
    if (noise_is_known) return {parse_tolerance("z=auto@edges")};
    if (encoding == Encoding::scene_referred)
        return {parse_tolerance("rel=0.01@edges"), parse_tolerance("energy=0.005")};
    return {parse_tolerance(bits > 8 ? "abs=0.001@edges" : "abs=0.0079@edges"),
            parse_tolerance("energy=0.01")};
}

int integer_bits(const Image& image) {
    const auto found = std::ranges::find(image.attributes, "steradian:integer_bits", &image::Attribute::name);
    return found == image.attributes.end() ? 0 : std::atoi(found->value.c_str());
}

void set_encoding(CompareOptions& options, const Image& test, const Image& reference) {
    const int bits = std::min(integer_bits(test), integer_bits(reference));
    options.encoding = bits > 0 ? Encoding::display_referred : Encoding::scene_referred;
    options.bits = bits > 0 ? bits : 8;
}

Comparison compare(const Image& test, const Image& reference, const CompareOptions& options) {
    Comparison comparison;
    const std::string difference = incompatibility(test, reference, options.layer);
    if (!difference.empty()) {
        comparison.verdicts.push_back({false, "the same size and channels: " + difference});
        comparison.diagnosis = diagnose_unequal_sizes(test, reference, options);
        return comparison;
    }
    const AlignedImages images = align(test, reference, options);
    Measurements measurements = measure(images, options);
    judge(images, measurements, options, comparison);
    judge_other_channels(test, reference, options, comparison);
    comparison.passed = std::ranges::all_of(comparison.verdicts, &Verdict::passed);
    comparison.metrics = measurements.metrics;
    if (!comparison.passed && !images.compared.empty())
        comparison.diagnosis = diagnose(images, comparison.error, test, reference, options,
                                        measurements.noise ? &measurements.noise->pixels : nullptr);
    return comparison;
}

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
    const auto add = [&](const std::string& name, const auto& value) {
        if constexpr (std::is_same_v<decltype(value), const double&>) {
            if (!std::isnan(value)) json[name] = number(value);
        } else if (m.pixels > 0) {
            json[name] = {number(value[0]), number(value[1]), number(value[2])};
        }
    };
    for (const NamedMetric& metric : named_metrics)
        std::visit([&](auto member) { add(std::string(metric.name), m.*member); }, metric.member);
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

} // namespace sr::compare
