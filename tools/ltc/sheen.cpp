// The albedo of sheen (KHR_materials_sheen: Charlie), in doubles and with none of the shaders' code. Printed
// as assets/lut/charlie_albedo.inc has it: 64 rows of roughness^⅔, in each 64 views, ∛cosθ_o. Even steps of
// these are fine where fibres shine, at grazing.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace {

constexpr int grid = 64;
constexpr double pi = std::numbers::pi;

/// Λ of Conty Estevez & Kulla 2017, section 2 (table 1 between α = 1 and α = 0).
double lambda(double c, double alpha) {
    const double t = (1.0 - alpha) * (1.0 - alpha);
    const auto mixed = [t](double a, double b) { return a + (b - a) * t; };
    const auto log_lambda = [&](double x) {
        return mixed(21.5473, 25.3245)
                   / (1.0 + mixed(3.82987, 3.32435) * std::pow(x, mixed(0.19823, 0.16801)))
               + mixed(-1.97760, -1.27393) * x + mixed(-4.32054, -4.85967);
    };
    return c < 0.5 ? std::exp(log_lambda(c)) : std::exp(2.0 * log_lambda(0.5) - log_lambda(1.0 - c));
}

/// ∫ D V cosθ_i dω_i by midpoints in φ and √cosθ_i, which lie close where fibres shine: at grazing.
double albedo(double cos_o, double alpha) {
    constexpr int rings = 256, spokes = 256;
    cos_o = std::max(cos_o, 1e-4); // as brdf/charlie.glsl
    const double sin_o = std::sqrt(1.0 - cos_o * cos_o), lambda_o = lambda(cos_o, alpha);
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double u = (i + 0.5) / rings, cos_i = u * u, sin_i = std::sqrt(1.0 - cos_i * cos_i);
        double over_phi = 0.0;
        for (int j = 0; j < spokes; ++j) {
            const double cos_phi = std::cos(pi * (j + 0.5) / spokes);
            const double h2 = 2.0 + 2.0 * (cos_i * cos_o + sin_i * sin_o * cos_phi); // |wi + wo|²
            const double sin2 = std::max(1.0 - (cos_i + cos_o) * (cos_i + cos_o) / h2, 0.0);
            over_phi += std::pow(sin2, 0.5 / alpha);
        }
        const double D = (2.0 + 1.0 / alpha) * over_phi / spokes; // 2π times the mean of D over φ
        sum += D / (4.0 * cos_o * (1.0 + lambda(std::max(cos_i, 1e-4), alpha) + lambda_o)) * 2.0 * u;
    }
    return sum / rings;
}

} // namespace

int main() {
    std::printf("// Made by fit_sheen (tools/ltc/). Albedo of Charlie sheen: %d rows of roughness^⅔ from 0 "
                "to 1, in each %d\n"
                "// views, ∛cosθ_o from 0 to 1.\n",
                grid, grid);
    for (int row = 0; row < grid; ++row) {
        const double v = static_cast<double>(row) / (grid - 1);
        const double alpha = std::max(v * v * v, 1e-4); // roughness²
        for (int column = 0; column < grid; ++column) {
            const double u = static_cast<double>(column) / (grid - 1);
            std::printf("%.5ff,%c", albedo(u * u * u, alpha), column % 8 == 7 ? '\n' : ' ');
        }
    }
    return 0;
}
