#include "compare/align.hpp"
#include "compare/hypotheses/hypothesis.hpp"

#include <fmt/format.h>

namespace sr::compare {
namespace {

/// A light's own contribution to the reference.
struct Light {
    std::string name;
    std::vector<float> values; // as DiagnosisInput::reference

    float at(std::size_t pixel, std::size_t channel) const { return values[pixel * 3 + channel]; }
    float sum_at(std::size_t pixel) const { return at(pixel, 0) + at(pixel, 1) + at(pixel, 2); }
};

std::vector<Light> lights_of(const image::Image& reference) {
    std::vector<Light> lights;
    for (const std::string& name : layer_names(reference))
        if (name != "albedo" && name != "irradiance") // terms, by steradian render --aov
            lights.push_back({name, extract(reference, layer_of(reference, name)->colors).pixels});
    return lights;
}

/// k of t = r + k L, by least squares of relative differences.
double fitted_share(const DiagnosisInput& in, const Light& light) {
    double product = 0.0, square = 0.0;
    for (const std::size_t i : in.pixels)
        for (std::size_t c = 0; c < 3; ++c) {
            const double scale = static_cast<double>(std::max(std::abs(in.r(i, c)), in.floor));
            const double L = static_cast<double>(light.at(i, c)) / scale;
            product += static_cast<double>(in.t(i, c) - in.r(i, c)) / scale * L;
            square += L * L;
        }
    return square > 0.0 ? product / square : 0.0;
}

void add_strength(const DiagnosisInput& in, const Light& light, Hypotheses& out) {
    const auto left = [&](float k) {
        return residual(in, [&](std::size_t i, std::size_t c) { return in.r(i, c) + k * light.at(i, c); });
    };
    out.push_back({{"light_missing", fmt::format("test = reference without the light '{}'", light.name),
                    left(-1.0f), light.name},
                   1});
    out.push_back(
        {{"light_doubled", fmt::format("test = reference with the light '{}' counted twice", light.name),
          left(1.0f), light.name},
         2});
    const auto k = static_cast<float>(fitted_share(in, light));
    out.push_back({{"light_scaled",
                    fmt::format("test = reference with the light '{}' at {:.4g} times its strength",
                                light.name, 1.0f + k),
                    left(k), light.name},
                   5});
}

void add_pairs_missing(const DiagnosisInput& in, const std::vector<Light>& lights, Hypotheses& out) {
    for (std::size_t a = 0; a < lights.size(); ++a)
        for (std::size_t b = a + 1; b < lights.size(); ++b) {
            const double left = residual(in, [&](std::size_t i, std::size_t c) {
                return in.r(i, c) - lights[a].at(i, c) - lights[b].at(i, c);
            });
            out.push_back({{"lights_missing",
                            fmt::format("test = reference without the lights '{}' and '{}'", lights[a].name,
                                        lights[b].name),
                            left, lights[a].name + ", " + lights[b].name},
                           2});
        }
}

void add_all_missing(const DiagnosisInput& in, const std::vector<Light>& lights, Hypotheses& out) {
    std::string names;
    for (const Light& light : lights) names += (names.empty() ? "" : ", ") + light.name;
    const double left = residual(in, [&](std::size_t i, std::size_t c) {
        float rest = in.r(i, c);
        for (const Light& light : lights) rest -= light.at(i, c);
        return rest;
    });
    out.push_back({{"lights_missing", "test = reference without any of its lights", left, names}, 2});
}

/// Where a light does not reach, and whether the test is brighter just there.
struct Dark {
    double residual = 1.0;   // the larger of two: the share of the difference that lies elsewhere or darkens,
                             // and how much a lit pixel differs beside a dark one
    double brightened = 0.0; // share of the dark pixels
    double lit = 0.0;        // share of the pixels that the light reaches
};

Dark darkness(const DiagnosisInput& in, const Light& light) {
    float brightest = 0.0f;
    for (const std::size_t i : in.pixels) brightest = std::max(brightest, light.sum_at(i));
    double all = 0.0, in_light = 0.0, in_dark = 0.0;
    double lit = 0.0, dark = 0.0, brightened = 0.0;
    for (const std::size_t i : in.pixels) {
        double difference = 0.0, rise = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            difference += static_cast<double>(in.distance(in.t(i, c), in.r(i, c)));
            rise += static_cast<double>(in.t(i, c) - in.r(i, c));
        }
        all += difference;
        if (in.t(i, 0) + in.t(i, 1) + in.t(i, 2) <= in.floor) continue; // black
        const bool is_lit = light.sum_at(i) > 1e-3f * brightest;
        lit += is_lit;
        dark += !is_lit;
        (is_lit ? in_light : in_dark) += is_lit || rise > 0.0 ? difference : 0.0;
        brightened += !is_lit && rise > 0.0 && difference > 0.03;
    }
    if (in_dark == 0.0 || lit == 0.0) return {};
    return {std::max(1.0 - in_dark / all, in_light / lit / (in_dark / dark)), brightened / dark,
            lit / (lit + dark)};
}

/// The missing shadow of the light that explains the difference and whose dark pixels brightened most.
void add_shadows(const DiagnosisInput& in, const std::vector<Light>& lights, Hypotheses& out) {
    constexpr double min_brightened = 0.25; // the left of the darkness is on surfaces that face away
    constexpr double min_lit = 0.25;        // of the pixels; else the dark pixels say little
    constexpr double max_residual = 0.1;
    const Light* best = nullptr;
    Dark best_dark;
    for (const Light& light : lights) {
        const Dark dark = darkness(in, light);
        if (dark.brightened < min_brightened || dark.lit < min_lit || dark.residual > max_residual) continue;
        if (best && dark.brightened <= best_dark.brightened) continue;
        best = &light;
        best_dark = dark;
    }
    if (!best) return;
    out.push_back(
        {{"shadow_missing",
          fmt::format("test is brighter just where the light '{}' does not reach in the reference: its "
                      "shadow is missing",
                      best->name),
          best_dark.residual, best->name},
         6});
}

} // namespace

void hypotheses_lights(const DiagnosisInput& in, const image::Image& reference, Hypotheses& out) {
    constexpr std::size_t max_in_pairs = 8;
    if (in.colors != 3) return;
    const std::vector<Light> lights = lights_of(reference);
    for (const Light& light : lights) add_strength(in, light, out);
    if (lights.size() <= max_in_pairs) add_pairs_missing(in, lights, out);
    if (lights.size() > 2) add_all_missing(in, lights, out);
    add_shadows(in, lights, out);
}

} // namespace sr::compare
