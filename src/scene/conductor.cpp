// n and k of metals, measured on films at room temperature, from 381 to 821 nm. The columns are those of
//
//   gold, silver, copper: Johnson & Christy 1972, "Optical constants of the noble metals", Phys. Rev. B 6,
//   table I chromium, iron, titanium: Johnson & Christy 1974, "Optical constants of transition metals", Phys.
//   Rev. B 9, table I aluminium: McPeak et al. 2015, "Plasmonic films can easily be better", ACS Photonics 2,
//   supplement, every 20 nm
//
// as refractiveindex.info has them (public domain, CC0).
#include "scene/conductor.hpp"

#include "core/error.hpp"
#include "scene/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sr::scene {
namespace {

using glm::dvec3;

// clang-format off
constexpr std::array<double, 15> johnson_nm{381.5, 397.4, 413.3, 430.5, 450.9, 471.4, 495.9, 520.9, 548.6, 582.1, 616.8, 659.5, 704.5, 756.0, 821.1};
constexpr std::array<double, 15> gold_n{1.46, 1.47, 1.46, 1.45, 1.38, 1.31, 1.04, 0.62, 0.43, 0.29, 0.21, 0.14, 0.13, 0.14, 0.16};
constexpr std::array<double, 15> gold_k{1.933, 1.952, 1.958, 1.948, 1.914, 1.849, 1.833, 2.081, 2.455, 2.863, 3.272, 3.697, 4.103, 4.542, 5.083};
constexpr std::array<double, 15> silver_n{0.05, 0.05, 0.05, 0.04, 0.04, 0.05, 0.05, 0.05, 0.06, 0.05, 0.06, 0.05, 0.04, 0.03, 0.04};
constexpr std::array<double, 15> silver_k{1.864, 2.070, 2.275, 2.462, 2.657, 2.869, 3.093, 3.324, 3.586, 3.858, 4.152, 4.483, 4.838, 5.242, 5.727};
constexpr std::array<double, 15> copper_n{1.33, 1.32, 1.28, 1.25, 1.24, 1.25, 1.22, 1.18, 1.02, 0.70, 0.30, 0.22, 0.21, 0.24, 0.26};
constexpr std::array<double, 15> copper_k{2.045, 2.116, 2.207, 2.305, 2.397, 2.483, 2.564, 2.608, 2.577, 2.704, 3.205, 3.747, 4.205, 4.665, 5.180};
constexpr std::array<double, 15> chromium_n{1.92, 2.00, 2.08, 2.19, 2.33, 2.51, 2.75, 2.94, 3.18, 3.22, 3.17, 3.09, 3.05, 3.08, 3.20};
constexpr std::array<double, 15> chromium_k{2.74, 2.83, 2.93, 3.04, 3.14, 3.24, 3.30, 3.33, 3.33, 3.30, 3.30, 3.34, 3.39, 3.42, 3.48};
constexpr std::array<double, 15> iron_n{2.12, 2.24, 2.35, 2.48, 2.59, 2.67, 2.74, 2.86, 2.95, 2.94, 2.88, 2.92, 2.86, 2.87, 2.94};
constexpr std::array<double, 15> iron_k{2.50, 2.58, 2.65, 2.71, 2.77, 2.82, 2.88, 2.91, 2.93, 2.99, 3.05, 3.10, 3.19, 3.28, 3.39};
constexpr std::array<double, 15> titanium_n{1.99, 2.08, 2.14, 2.21, 2.27, 2.32, 2.36, 2.44, 2.54, 2.60, 2.67, 2.76, 2.86, 3.00, 3.21};
constexpr std::array<double, 15> titanium_k{2.93, 2.95, 2.98, 3.01, 3.04, 3.10, 3.19, 3.30, 3.43, 3.58, 3.72, 3.84, 3.96, 4.01, 4.01};
constexpr std::array<double, 24> mcpeak_nm{360, 380, 400, 420, 440, 460, 480, 500, 520, 540, 560, 580, 600, 620, 640, 660, 680, 700, 720, 740, 760, 780, 800, 820};
constexpr std::array<double, 24> aluminium_n{0.3001, 0.3360, 0.3752, 0.4176, 0.4642, 0.5148, 0.5680, 0.6257, 0.6883, 0.7545, 0.8292, 0.9086, 0.9925, 1.0882, 1.1903, 1.3044, 1.4260, 1.5598, 1.7068, 1.8722, 2.0542, 2.2315, 2.3737, 2.4100};
constexpr std::array<double, 24> aluminium_k{3.7763, 4.0026, 4.2264, 4.4474, 4.6691, 4.8879, 5.1059, 5.3205, 5.5360, 5.7465, 5.9582, 6.1652, 6.3690, 6.5666, 6.7594, 6.9424, 7.1163, 7.2739, 7.4142, 7.5284, 7.5995, 7.6039, 7.5226, 7.3694};
// clang-format on

template<std::size_t count>
IorSpectrum spectrum_of(const std::array<double, count>& nm, const std::array<double, count>& n,
                        const std::array<double, count>& k) {
    IorSpectrum spectrum;
    for (std::size_t i = 0; i < count; ++i) spectrum.push_back({nm[i], n[i], k[i]});
    return spectrum;
}

const std::vector<std::pair<std::string_view, IorSpectrum>>& metals() {
    static const std::vector<std::pair<std::string_view, IorSpectrum>> all{
        {"aluminium", spectrum_of(mcpeak_nm, aluminium_n, aluminium_k)},
        {"chromium", spectrum_of(johnson_nm, chromium_n, chromium_k)},
        {"copper", spectrum_of(johnson_nm, copper_n, copper_k)},
        {"gold", spectrum_of(johnson_nm, gold_n, gold_k)},
        {"iron", spectrum_of(johnson_nm, iron_n, iron_k)},
        {"silver", spectrum_of(johnson_nm, silver_n, silver_k)},
        {"titanium", spectrum_of(johnson_nm, titanium_n, titanium_k)}};
    return all;
}

IorPoint at(const IorSpectrum& spectrum, double wavelength) {
    const auto above = std::upper_bound(spectrum.begin(), spectrum.end(), wavelength,
                                        [](double w, const IorPoint& p) { return w < p.wavelength; });
    if (above == spectrum.begin()) return spectrum.front();
    if (above == spectrum.end()) return spectrum.back();
    const IorPoint &a = *(above - 1), &b = *above;
    const double t = (wavelength - a.wavelength) / (b.wavelength - a.wavelength);
    return {wavelength, glm::mix(a.n, b.n, t), glm::mix(a.k, b.k, t)};
}

constexpr int angles = 16; // of the fit
double cosine(int i) { return (i + 0.5) / angles; }

/// Returns the squared difference between Fresnel's reflectance and the wanted one, over all angles.
double misfit(double n, double k, const std::array<double, angles>& wanted) {
    double sum = 0.0;
    for (int i = 0; i < angles; ++i)
        sum += std::pow(fresnel_conductor(cosine(i), n, k) - wanted[static_cast<std::size_t>(i)], 2.0);
    return sum;
}

/// Hooke & Jeeves 1961: steps along the axes, halved where none helps.
std::pair<double, double> nearest_ior(double n, double k, const std::array<double, angles>& wanted) {
    constexpr double smallest = 1e-3, largest = 20.0;
    double best = misfit(n, k, wanted);
    for (double step = 0.5; step > 1e-5;) {
        const double old = best;
        for (const auto& [dn, dk] : {std::pair(step, 0.0),
                                     {-step, 0.0},
                                     {0.0, step},
                                     {0.0, -step},
                                     {step, step},
                                     {-step, -step},
                                     {step, -step},
                                     {-step, step}}) {
            const double n1 = std::clamp(n + dn, smallest, largest), k1 = std::clamp(k + dk, 0.0, largest);
            const double now = misfit(n1, k1, wanted);
            if (now < best) best = now, n = n1, k = k1;
        }
        if (best == old) step *= 0.5;
    }
    return {n, k};
}

} // namespace

std::optional<IorSpectrum> measured_metal(std::string_view name) {
    for (const auto& [known, spectrum] : metals())
        if (known == name) return spectrum;
    return std::nullopt;
}

std::vector<std::string_view> metal_names() {
    std::vector<std::string_view> names;
    for (const auto& [name, spectrum] : metals()) names.push_back(name);
    return names;
}

double fresnel_conductor(double c, double n, double k) {
    const double s2 = 1.0 - c * c, t = n * n - k * k - s2;
    const double ab = std::sqrt(t * t + 4.0 * n * n * k * k); // a² + b²
    const double a = std::sqrt(std::max(0.5 * (ab + t), 0.0));
    const double Rs = (ab - 2.0 * a * c + c * c) / (ab + 2.0 * a * c + c * c);
    const double Rp =
        Rs * (c * c * ab - 2.0 * a * c * s2 + s2 * s2) / (c * c * ab + 2.0 * a * c * s2 + s2 * s2);
    return 0.5 * (Rs + Rp);
}

dvec3 reflectance_of(const IorSpectrum& spectrum, double cos_theta) {
    constexpr double white = 6504.0; // [K]
    dvec3 reflected(0.0), arriving(0.0);
    for (double w = first_wavelength; w <= last_wavelength; w += observer_step) {
        const dvec3 light = planck(w, white) * observer(w);
        const IorPoint ior = at(spectrum, w);
        arriving += light;
        reflected += fresnel_conductor(cos_theta, ior.n, ior.k) * light;
    }
    return glm::clamp(rgb_of_xyz(reflected) / rgb_of_xyz(arriving), dvec3(0.0), dvec3(1.0));
}

ComplexIor fit_ior(const IorSpectrum& spectrum) {
    require(!spectrum.empty(), "the spectrum has points");
    std::array<std::array<double, angles>, 3> wanted{};
    for (int i = 0; i < angles; ++i) {
        const dvec3 R = reflectance_of(spectrum, cosine(i));
        for (int c = 0; c < 3; ++c) wanted[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] = R[c];
    }
    constexpr std::array<double, 3> typical{610.0, 550.0, 465.0}; // [nm], where the fit of a channel begins
    ComplexIor ior;
    for (int c = 0; c < 3; ++c) {
        const IorPoint start = at(spectrum, typical[static_cast<std::size_t>(c)]);
        const auto [n, k] = nearest_ior(start.n, start.k, wanted[static_cast<std::size_t>(c)]);
        ior.n[c] = static_cast<float>(n);
        ior.k[c] = static_cast<float>(k);
    }
    return ior;
}

} // namespace sr::scene
