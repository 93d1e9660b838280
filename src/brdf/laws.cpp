#include "brdf/laws.hpp"

#include "core/math.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <random>

namespace sr::brdf {
namespace {

constexpr int pair_count = 4096, albedo_directions = 1 << 14, density_directions = 1 << 15;
constexpr int sample_rows = 128; // squared: how many directions are sampled

vec3 direction(float cos_theta, float phi) {
    const float s = std::sqrt(std::max(0.0f, 1.0f - cos_theta * cos_theta));
    return {s * std::cos(phi), s * std::sin(phi), cos_theta};
}

std::string text_of(vec3 w) {
    return fmt::format("θ {:.1f}°, φ {:.0f}°", glm::degrees(std::acos(std::clamp(w.z, -1.0f, 1.0f))),
                       glm::degrees(std::atan2(w.y, w.x)));
}

/// Keeps the worst case. What is not a number is worst of all.
void keep_worst(Law& law, double value, const std::string& where) {
    if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
    if (value <= law.worst && !law.where.empty()) return;
    law.worst = value;
    law.where = where;
}

/// Over the hemisphere, every other pair about the mirrored direction, where lobes have their peaks.
std::vector<DirectionPair> random_pairs() {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::normal_distribution<float> spread(0.0f, 0.1f);
    const auto any = [&] { return direction(0.02f + 0.98f * unit(random), 2.0f * pi * unit(random)); };
    std::vector<DirectionPair> pairs;
    for (int i = 0; i < pair_count; ++i) {
        DirectionPair pair{any(), any()};
        if (i % 2 == 0) {
            const vec3 near = vec3(-pair.wo.x, -pair.wo.y, pair.wo.z)
                              + vec3(spread(random), spread(random), spread(random));
            pair.wi = glm::normalize(vec3(near.x, near.y, std::max(std::abs(near.z), 0.02f)));
        }
        pairs.push_back(pair);
    }
    return pairs;
}

float largest(vec3 v) { return std::max(v.x, std::max(v.y, v.z)); }

void check_values(BrdfEvaluator& evaluator, Law& reciprocity, Law& negativity) {
    const std::vector<DirectionPair> pairs = random_pairs();
    std::vector<DirectionPair> swapped;
    for (const DirectionPair& pair : pairs) swapped.push_back({pair.wo, pair.wi});
    const std::vector<vec3> there = evaluator.evaluate(pairs), back = evaluator.evaluate(swapped);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const std::string where = "wi " + text_of(pairs[i].wi) + ", wo " + text_of(pairs[i].wo);
        const vec3 f = there[i], g = back[i];
        const float scale = std::max(largest(f), largest(g));
        keep_worst(reciprocity, scale > 0.0f ? largest(glm::abs(f - g)) / scale : 0.0, where);
        const float lowest = std::min(f.x, std::min(f.y, f.z));
        keep_worst(negativity, std::isfinite(f.x + f.y + f.z) ? std::max(-lowest, 0.0f) : NAN, where);
    }
}

void check_energy(BrdfEvaluator& evaluator, Law& energy) {
    const std::vector<vec3> wo = viewing_directions();
    const std::vector<glm::dvec3> albedos = evaluator.albedos(wo, albedo_directions);
    for (std::size_t i = 0; i < wo.size(); ++i)
        keep_worst(energy, std::max(albedos[i].x, std::max(albedos[i].y, albedos[i].z)), text_of(wo[i]));
}

constexpr int rings = 8, sectors = 12;
constexpr std::size_t below = rings * sectors; // what lies below the horizon is a cell as well

std::size_t cell_of(vec3 w) {
    if (!(w.z > 0.0f)) return below;
    const int ring = std::min(static_cast<int>(w.z * rings), rings - 1);
    const float turn = std::atan2(w.y, w.x) / (2.0f * pi) + 0.5f;
    return static_cast<std::size_t>(ring * sectors + std::min(static_cast<int>(turn * sectors), sectors - 1));
}

/// Points of the unit square: one at random in each cell of a grid, or all at random.
std::vector<vec2> random_points(bool is_stratified) {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f - 1e-6f);
    std::vector<vec2> points;
    for (int i = 0; i < sample_rows * sample_rows; ++i) {
        const vec2 p(unit(random), unit(random));
        const vec2 cell(static_cast<float>(i % sample_rows), static_cast<float>(i / sample_rows));
        points.push_back(is_stratified ? (cell + p) / static_cast<float>(sample_rows) : p);
    }
    return points;
}

/// The number of sampled directions in each cell.
std::vector<double> drawn(BrdfEvaluator& evaluator, vec3 wo, bool is_stratified) {
    std::vector<double> counts(below + 1, 0.0);
    for (const WeightedDirection& w : evaluator.samples(wo, random_points(is_stratified)))
        counts[cell_of(w.wi)] += 1.0;
    return counts;
}

void check_sampling(BrdfEvaluator& evaluator, Law& normalisation, Law& sampling) {
    constexpr double count = sample_rows * sample_rows;
    const std::vector<vec3> views = viewing_directions();
    for (const vec3 wo : {views[1], views[2], views[4]}) {
        std::vector<double> expected(below + 1, 0.0);
        for (const WeightedDirection& w : evaluator.densities(wo, density_directions))
            if (w.wi.z > 0.0f)
                expected[cell_of(w.wi)] += static_cast<double>(w.weight) * count / density_directions;
        double above = 0.0;
        for (const double e : expected) above += e;
        const double is_below = drawn(evaluator, wo, true)[below];
        keep_worst(normalisation, std::abs((above + is_below) / count - 1.0), text_of(wo));
        expected[below] = is_below;
        keep_worst(sampling, chi_squared_excess(expected, drawn(evaluator, wo, false)).value_or(0.0),
                   text_of(wo));
    }
}

} // namespace

std::vector<vec3> viewing_directions() {
    std::vector<vec3> directions;
    int i = 0;
    for (const float c : {0.05f, 0.2f, 0.5f, 0.8f, 0.999f})
        directions.push_back(direction(c, 0.7f * static_cast<float>(i++)));
    return directions;
}

std::vector<Law> check_laws(BrdfEvaluator& evaluator) {
    Law reciprocity{"reciprocity", 0.0, 1e-4, {}, !evaluator.tested().is_reciprocal()};
    Law negativity{"negativity", 0.0, 0.0, {}},
        energy{"energy", 0.0, 1.0 + 1e-3, {}, !evaluator.tested().keeps_energy()};
    check_values(evaluator, reciprocity, negativity);
    check_energy(evaluator, energy);
    std::vector<Law> laws{reciprocity, negativity, energy};
    if (!evaluator.tested().has_sampling()) return laws;
    Law normalisation{"normalisation", 0.0, 1e-2, {}}, sampling{"sampling", 0.0, 5.0, {}};
    check_sampling(evaluator, normalisation, sampling);
    laws.push_back(normalisation);
    laws.push_back(sampling);
    return laws;
}

} // namespace sr::brdf
