// Fits a linearly transformed cosine to GGX for every view and roughness of a grid, and writes the table that
// the renderer reads: fit_ltc > assets/lut/ggx_ltc.inc. The same bytes every time; seconds.
#include "ggx.hpp"
#include "simplex.hpp"

#include <cstdio>
#include <vector>

namespace {

using namespace sr::ltc;

constexpr int grid = 32; // src/render/gpu/ltc_table.hpp has the same number

struct Sample {
    dvec3 wi;
    double f;     // f_r cosθ [1/sr]
    double share; // f_r cosθ / p: of the albedo
};

struct Fit {
    Lobe lobe;
    double albedo = 0.0;  // ∫ D V cosθ dω
    double schlick = 0.0; // ∫ (1 - w·h)⁵ D V cosθ dω
};

/// Directions where the lobe is, distributed as visible normals on a regular grid.
std::vector<Sample> samples_of(dvec3 wo, double alpha, int rings, int sectors) {
    std::vector<Sample> samples;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const dvec3 wi = visible_direction((i + 0.5) / rings, (j + 0.5) / sectors, wo, alpha);
            const double f = f_cos(wi, wo, alpha);
            if (f > 0.0) samples.push_back({wi, f, f / p_visible(wi, wo, alpha) / (rings * sectors)});
        }
    return samples;
}

/// Minimises the Kullback-Leibler divergence ∫ f log(f / density): light from where the lobe is counts, and
/// the ratio f / density, which the points of an emitter average, stays even.
Fit fitted(double cos_o, double alpha, const Lobe& start) {
    const dvec3 wo = direction_at(cos_o);
    const std::vector<Sample> samples = samples_of(wo, alpha, 48, 48);
    const auto lobe_at = [](const Place& p) { return Lobe{std::exp(p[0]), std::sinh(p[2]), std::exp(p[1])}; };
    const auto divergence = [&](const Place& p) {
        const Lobe lobe = lobe_at(p);
        double sum = 0.0;
        for (const Sample& s : samples) sum += s.share * std::log(s.f / lobe.density(s.wi));
        return std::isfinite(sum) ? sum : 1e300;
    };
    Place place{std::log(start.a), std::log(start.c), std::asinh(start.b)};
    place = minimum(divergence, place, 0.2, 120);
    place = minimum(divergence, place, 0.05, 120); // a fresh simplex where the first may have collapsed
    Fit fit{lobe_at(place)};
    for (const Sample& s : samples_of(wo, alpha, 400, 96)) { // the horizon cuts the grid: finer
        fit.albedo += s.share;
        fit.schlick += s.share * schlick_weight(s.wi, wo);
    }
    return fit;
}

/// Prints an entry of the table, normalised by its place in the grid (shaders/brdf/warp.glsl undoes it). For
/// α → 0 the lobe is a = 2α / cos²θ_o, b = tanθ_o, c = 2α: divided by that, or by what it would be at
/// grazing, the numbers are smooth.
void print_entry(const Fit& fit, double cos_o, double scaled_b, double alpha) {
    const double softened = cos_o * cos_o + alpha * alpha;
    std::printf("%.5ff, %.5ff, %.5ff, %.5ff, %.5ff,\n", fit.lobe.a * softened / (2.0 * alpha), scaled_b,
                fit.lobe.c / (2.0 * alpha), fit.albedo, fit.schlick);
}

double scaled_b(const Fit& fit, double cos_o, double alpha) {
    const double scaled = fit.lobe.b * std::sqrt((cos_o * cos_o + alpha * alpha) / (1.0 - cos_o * cos_o));
    return std::abs(scaled) < 5e-6 ? 0.0 : scaled; // "-0.00000" would depend on the compiler
}

} // namespace

int main() {
    std::printf(
        "// Made by fit_ltc (tools/ltc/). GGX as a linearly transformed cosine: %d rows of roughness from 0\n"
        "// to 1, in each %d views, √cosθ_o from 0 to 1. Entries: a, b, c (scaled), albedo, Schlick's "
        "part.\n",
        grid, grid);
    for (int row = 0; row < grid; ++row) {
        const double roughness = static_cast<double>(row) / (grid - 1);
        const double alpha = std::max(roughness * roughness, 1e-4); // min_alpha of the shaders
        std::vector<Fit> views(grid);
        Lobe start{2.0 * alpha, 0.0, 2.0 * alpha};
        for (int column = grid - 1; column >= 0; --column) { // from the simple lobe of normal incidence on
            const double u = static_cast<double>(column) / (grid - 1);
            views[column] = fitted(u * u, alpha, start);
            start = views[column].lobe;
        }
        double b = 0.0;
        for (int column = 0; column < grid; ++column) {
            const double u = static_cast<double>(column) / (grid - 1);
            // At normal incidence b is 0 whatever its scaled value, so the neighbour's goes on.
            if (column < grid - 1) b = scaled_b(views[column], u * u, alpha);
            print_entry(views[column], u * u, b, alpha);
        }
    }
    return 0;
}
