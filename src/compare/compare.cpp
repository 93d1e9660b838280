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

bool limits_appearance(const Tolerance& tolerance) {
    return tolerance.measure == Measure::flip || tolerance.measure == Measure::hdr_flip
           || tolerance.measure == Measure::ssim;
}

Measurements measure(const AlignedImages& images, const CompareOptions& options) {
    Measurements measurements;
    measure_differences(images, measurements.metrics);
    if (images.compared.empty()) return measurements;
    measurements.abs = absolute_differences(images);
    measurements.floors.assign(static_cast<std::size_t>(images.colors), measurements.metrics.floor);
    measurements.rel = relative_differences(images, measurements.floors);
    if (!options.noise.empty()) {
        measurements.noise = score_noise(images, options.noise, {});
        measurements.metrics.max_z = std::ranges::max(measurements.noise->pixels);
        measurements.metrics.max_block_z = measurements.noise->max_block;
        measurements.metrics.total_z = measurements.noise->total;
    }
    if (options.measures_appearance || std::ranges::any_of(options.tolerances, limits_appearance))
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

/// Fills in what follows from the errors over the limits, which it returns.
PixelValues finish_measurements(const AlignedImages& images, const std::vector<Tolerance>& tolerances,
                                const std::vector<Tolerance>& by_pixel, Measurements& measurements) {
    measurements.even_energy_ratios =
        energy_ratios(images, pixels_at_edges(images, measurements, tolerances));
    PixelValues errors = errors_over_limits(images, measurements, by_pixel);
    std::vector<bool> fails;
    for (const float error : errors) fails.push_back(!(error <= 1.0f));
    measurements.metrics.failing_fraction =
        static_cast<double>(std::ranges::count(fails, true)) / static_cast<double>(fails.size());
    measurements.metrics.density = densest_window(images, fails, density_window).share;
    return errors;
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
    const PixelValues errors =
        finish_measurements(images, tolerances, pixel_tolerances(tolerances, options), measurements);
    for (const Tolerance& tolerance : tolerances)
        comparison.verdicts.push_back(judge(tolerance, images, measurements));
    comparison.error = error_map(images, errors);
}

/// The limits for layers: those of the picture that are neither on its appearance nor on its noise, and the
/// default ones on pixels if none of these is left.
std::vector<Tolerance> layer_tolerances(const CompareOptions& options) {
    std::vector<Tolerance> tolerances = tolerances_in_use(options);
    std::erase_if(tolerances,
                  [](const Tolerance& t) { return limits_appearance(t) || t.measure == Measure::z; });
    if (std::ranges::any_of(tolerances, &Tolerance::by_pixel)) return tolerances;
    for (const Tolerance& tolerance : default_tolerances(options.encoding, false, options.bits))
        if (tolerance.by_pixel || tolerances.empty()) tolerances.push_back(tolerance);
    return tolerances;
}

/// A layer beside the picture, or its alpha.
struct JudgedLayer {
    std::string title;                 // "layer key"
    std::vector<std::string> channels; // by which a noise image names its errors
    AlignedImages images;
    std::vector<double> floors;
    RareEvents rare{}; // beside its noise
};

/// The layers beside the picture that were judged.
struct LayerCount {
    std::size_t compared = 0;
    std::size_t rare_events = 0; // pixels that were left out
    std::string without_noise;   // those that a tolerance judges, though noise is given
};

/// Judges a layer by its own noise if that is given, else by the tolerances, and adds its errors to the error
/// map.
void judge_layer(const JudgedLayer& layer, const CompareOptions& options, Comparison& comparison,
                 LayerCount& count) {
    const AlignedImages& images = layer.images;
    ++count.compared;
    const std::vector<Image> noise =
        layer.channels.empty() ? std::vector<Image>{} : noise_of(options.noise, layer.channels);
    if (noise.empty() && !options.noise.empty())
        count.without_noise += (count.without_noise.empty() ? "" : ", ") + layer.title;
    const auto add = [&](const Verdict& verdict) {
        if (!verdict.passed)
            comparison.verdicts.push_back(
                {false, fmt::format("{}{}: {}", layer.title,
                                    noise.empty() && !options.noise.empty() ? " (of unknown noise)" : "",
                                    verdict.line)});
    };
    add(judge_finite(images, options.allow_nonfinite));
    if (images.compared.empty()) return;
    Measurements measurements;
    measure_differences(images, measurements.metrics);
    measurements.floors = layer.floors;
    measurements.abs = absolute_differences(images);
    measurements.rel = relative_differences(images, measurements.floors);
    std::vector<Tolerance> tolerances = layer_tolerances(options);
    if (!noise.empty()) {
        measurements.noise = score_noise(images, noise, layer.channels, layer.rare);
        count.rare_events += measurements.noise->rare_events.size();
        tolerances = default_tolerances(options.encoding, true);
    }
    const PixelValues errors = finish_measurements(images, tolerances, tolerances, measurements);
    for (const Tolerance& tolerance : tolerances) add(judge(tolerance, images, measurements));
    for (std::size_t k = 0; k < errors.size(); ++k) {
        float& error = comparison.error.pixels[images.compared[k]];
        if (error >= 0.0f) error = std::max(error, errors[k]);
    }
}

/// Leaves out the pixels beside which the alpha of the reference changes: other samples cover its edges
/// otherwise, and few seeds may agree there by chance.
AlignedImages without_edges(AlignedImages alpha) {
    const Image& reference = alpha.reference;
    const auto is_even = [&](int x, int y) {
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, reference.height - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, reference.width - 1); ++u)
                if (reference.at(u, v)[0] != reference.at(x, y)[0]) return false;
        return true;
    };
    std::erase_if(alpha.compared, [&](std::size_t i) {
        const bool is_left_out =
            !is_even(static_cast<int>(i) % reference.width, static_cast<int>(i) / reference.width);
        if (is_left_out) alpha.pixels[i] = PixelState::excluded;
        return is_left_out;
    });
    return alpha;
}

/// Judges all channels of the reference but the picture's colours: none may be missing. Without known noise
/// alpha is judged with the colours.
/// @param rare the pixels of the colours that were left out
void judge_other_channels(const AlignedImages& images, const Image& test, const Image& reference,
                          const CompareOptions& options, const std::vector<std::size_t>& rare,
                          Comparison& comparison) {
    std::string missing = lacks_alpha(test, reference, options.layer) ? "alpha" : "";
    const std::size_t before = comparison.verdicts.size();
    LayerCount count;
    if (!options.noise.empty() && images.reference.channels > images.colors) {
        const std::string name = options.layer.empty() ? "A" : options.layer + ".A";
        const JudgedLayer alpha{"alpha", {name}, without_edges(alpha_of(images)), {1.0}, {true, rare}};
        if (!alpha.images.compared.empty()) judge_layer(alpha, options, comparison, count);
    }
    if (options.layer.empty())
        for (const OtherLayer& layer : other_layers(test, reference)) {
            const auto& wanted = options.other_layers;
            if (wanted && std::ranges::find(*wanted, layer.name) == wanted->end()) continue;
            for (const std::string& channel : layer.missing)
                missing += (missing.empty() ? "" : ", ") + channel;
            if (layer.reference.empty()) continue;
            const AlignedImages both = align(test, reference, layer, options);
            judge_layer({layer.name.empty() ? "other channels" : "layer " + layer.name, layer.channels, both,
                         channel_floors(both)},
                        options, comparison, count);
        }
    if (!missing.empty())
        comparison.verdicts.push_back({false, "all channels of the reference: the test lacks " + missing});
    else if (count.compared > 0 && before == comparison.verdicts.size())
        comparison.verdicts.push_back(
            {true,
             fmt::format("other layers: {0} of {0} agree{1}{2}", count.compared,
                         count.without_noise.empty()
                             ? ""
                             : "; of unknown noise, so by the tolerance: " + count.without_noise,
                         count.rare_events == 0 ? ""
                                                : fmt::format("; {} single pixels left out as rare events",
                                                              count.rare_events))});
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
    const bool is_wrong_as_a_whole =
        std::ranges::any_of(tolerances_in_use(options), [&](const Tolerance& tolerance) {
            return !images.compared.empty() && !tolerance.by_pixel
                   && !judge(tolerance, images, measurements).passed;
        });
    const Image picture_error = comparison.error; // a layer's errors have no cause in the picture
    judge_other_channels(images, test, reference, options,
                         measurements.noise ? measurements.noise->rare_events : std::vector<std::size_t>{},
                         comparison);
    comparison.passed = std::ranges::all_of(comparison.verdicts, &Verdict::passed);
    comparison.metrics = measurements.metrics;
    if (!comparison.passed && options.diagnoses && !images.compared.empty())
        comparison.diagnosis = diagnose({images, picture_error, test, reference, is_wrong_as_a_whole, options,
                                         measurements.noise ? &measurements.noise->pixels : nullptr});
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
