#include "scene/spectrum.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sr::scene {

// CIE 15:2004, "Colorimetry", table T.4: colour-matching functions of the CIE 1931 standard colorimetric
// observer, 360 to 830 nm by 5 nm, to the seven digits that the CIE publishes (doi:10.25039/CIE.DS.xvudnb9b).

namespace {

// clang-format off
constexpr std::array<std::array<double, 3>, 95> table{{
    {0.0001299, 3.917e-06, 0.0006061}, {0.0002321, 6.965e-06, 0.001086}, {0.0004149, 1.239e-05, 0.001946},
    {0.0007416, 2.202e-05, 0.003486}, {0.001368, 3.9e-05, 0.00645}, {0.002236, 6.4e-05, 0.01055},
    {0.004243, 0.00012, 0.02005}, {0.00765, 0.000217, 0.03621}, {0.01431, 0.000396, 0.06785},
    {0.02319, 0.00064, 0.1102}, {0.04351, 0.00121, 0.2074}, {0.07763, 0.00218, 0.3713},
    {0.13438, 0.004, 0.6456}, {0.21477, 0.0073, 1.03905}, {0.2839, 0.0116, 1.3856},
    {0.3285, 0.01684, 1.62296}, {0.34828, 0.023, 1.74706}, {0.34806, 0.0298, 1.7826},
    {0.3362, 0.038, 1.77211}, {0.3187, 0.048, 1.7441}, {0.2908, 0.06, 1.6692}, {0.2511, 0.0739, 1.5281},
    {0.19536, 0.09098, 1.28764}, {0.1421, 0.1126, 1.0419}, {0.09564, 0.13902, 0.81295},
    {0.05795, 0.1693, 0.6162}, {0.03201, 0.20802, 0.46518}, {0.0147, 0.2586, 0.3533},
    {0.0049, 0.323, 0.272}, {0.0024, 0.4073, 0.2123}, {0.0093, 0.503, 0.1582}, {0.0291, 0.6082, 0.1117},
    {0.06327, 0.71, 0.07825}, {0.1096, 0.7932, 0.05725}, {0.1655, 0.862, 0.04216},
    {0.22575, 0.91485, 0.02984}, {0.2904, 0.954, 0.0203}, {0.3597, 0.9803, 0.0134},
    {0.43345, 0.99495, 0.00875}, {0.51205, 1.0, 0.00575}, {0.5945, 0.995, 0.0039},
    {0.6784, 0.9786, 0.00275}, {0.7621, 0.952, 0.0021}, {0.8425, 0.9154, 0.0018}, {0.9163, 0.87, 0.00165},
    {0.9786, 0.8163, 0.0014}, {1.0263, 0.757, 0.0011}, {1.0567, 0.6949, 0.001}, {1.0622, 0.631, 0.0008},
    {1.0456, 0.5668, 0.0006}, {1.0026, 0.503, 0.00034}, {0.9384, 0.4412, 0.00024},
    {0.85445, 0.381, 0.00019}, {0.7514, 0.321, 0.0001}, {0.6424, 0.265, 5e-05}, {0.5419, 0.217, 3e-05},
    {0.4479, 0.175, 2e-05}, {0.3608, 0.1382, 1e-05}, {0.2835, 0.107, 0.0}, {0.2187, 0.0816, 0.0},
    {0.1649, 0.061, 0.0}, {0.1212, 0.04458, 0.0}, {0.0874, 0.032, 0.0}, {0.0636, 0.0232, 0.0},
    {0.04677, 0.017, 0.0}, {0.0329, 0.01192, 0.0}, {0.0227, 0.00821, 0.0}, {0.01584, 0.005723, 0.0},
    {0.011359, 0.004102, 0.0}, {0.008111, 0.002929, 0.0}, {0.00579, 0.002091, 0.0},
    {0.004109, 0.001484, 0.0}, {0.002899, 0.001047, 0.0}, {0.002049, 0.00074, 0.0},
    {0.00144, 0.00052, 0.0}, {0.0009999, 0.0003611, 0.0}, {0.0006901, 0.0002492, 0.0},
    {0.000476, 0.0001719, 0.0}, {0.0003323, 0.00012, 0.0}, {0.0002348, 8.48e-05, 0.0},
    {0.0001662, 6e-05, 0.0}, {0.0001174, 4.24e-05, 0.0}, {8.308e-05, 3e-05, 0.0},
    {5.871e-05, 2.12e-05, 0.0}, {4.151e-05, 1.499e-05, 0.0}, {2.935e-05, 1.06e-05, 0.0},
    {2.067e-05, 7.466e-06, 0.0}, {1.456e-05, 5.258e-06, 0.0}, {1.025e-05, 3.703e-06, 0.0},
    {7.221e-06, 2.608e-06, 0.0}, {5.086e-06, 1.837e-06, 0.0}, {3.582e-06, 1.293e-06, 0.0},
    {2.523e-06, 9.109e-07, 0.0}, {1.777e-06, 6.415e-07, 0.0}, {1.251e-06, 4.518e-07, 0.0},
}};
// clang-format on

static_assert(first_wavelength + observer_step * (table.size() - 1) == last_wavelength);

} // namespace

glm::dvec3 observer(double wavelength) {
    if (!(wavelength >= first_wavelength && wavelength <= last_wavelength)) return glm::dvec3(0.0);
    const double place = (wavelength - first_wavelength) / observer_step;
    const auto below = std::min(static_cast<std::size_t>(place), table.size() - 2);
    const double f = place - static_cast<double>(below);
    const auto& a = table[below];
    const auto& b = table[below + 1];
    return glm::mix(glm::dvec3(a[0], a[1], a[2]), glm::dvec3(b[0], b[1], b[2]), f);
}

namespace {

using glm::dvec3;

/// Where a spectrum or the observer's table has a corner, within the spectrum.
std::vector<double> corners(const Spectrum& spectrum) {
    std::vector<double> places;
    for (const SpectrumPoint& point : spectrum) places.push_back(point.wavelength);
    for (double w = first_wavelength; w <= last_wavelength; w += observer_step)
        if (w > spectrum.front().wavelength && w < spectrum.back().wavelength) places.push_back(w);
    std::sort(places.begin(), places.end());
    return places;
}

double value_at(const Spectrum& spectrum, double wavelength) {
    const auto above = std::upper_bound(spectrum.begin(), spectrum.end(), wavelength,
                                        [](double w, const SpectrumPoint& p) { return w < p.wavelength; });
    if (above == spectrum.begin()) return 0.0;
    if (above == spectrum.end()) return wavelength > spectrum.back().wavelength ? 0.0 : spectrum.back().value;
    const SpectrumPoint& a = *(above - 1);
    return a.value
           + (above->value - a.value) * (wavelength - a.wavelength) / (above->wavelength - a.wavelength);
}

double power(const Spectrum& spectrum) { // ∫ S dλ, in its units times nm
    double sum = 0.0;
    for (std::size_t i = 1; i < spectrum.size(); ++i)
        sum += 0.5 * (spectrum[i].value + spectrum[i - 1].value)
               * (spectrum[i].wavelength - spectrum[i - 1].wavelength);
    return sum;
}

} // namespace

dvec3 rgb_of_xyz(dvec3 xyz) { // the rows of the matrix
    return {glm::dot(dvec3(3.2404542, -1.5371385, -0.4985314), xyz),
            glm::dot(dvec3(-0.9692660, 1.8760108, 0.0415560), xyz),
            glm::dot(dvec3(0.0556434, -0.2040259, 1.0572252), xyz)};
}

dvec3 xyz_of(const Spectrum& spectrum) {
    dvec3 sum(0.0);
    const std::vector<double> places = corners(spectrum);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const double a = places[i - 1], b = places[i], middle = 0.5 * (a + b);
        const auto f = [&](double w) { return value_at(spectrum, w) * observer(w); };
        sum += (b - a) / 6.0 * (f(a) + 4.0 * f(middle) + f(b)); // Simpson: exact for a product of two lines
    }
    return sum;
}

vec3 with_unit_luminance(dvec3 rgb) {
    rgb = glm::max(rgb, dvec3(0.0));
    const double Y = sr::luminance(rgb);
    return Y > 0.0 ? vec3(rgb / Y) : vec3(1.0f);
}

LightColor color_of(const Spectrum& spectrum) {
    const dvec3 xyz = xyz_of(spectrum);
    return {with_unit_luminance(rgb_of_xyz(xyz)), lumens_per_watt * xyz.y / power(spectrum)};
}

double planck(double wavelength, double temperature) {
    constexpr double c1 = 3.741771852e-16; // 2π h c² [W m²]
    constexpr double c2 = 1.438776877e-2;  // h c / k [m K]
    const double metres = 1e-9 * wavelength;
    return c1 / (std::pow(metres, 5.0) * std::expm1(c2 / (metres * temperature)));
}

LightColor color_of_blackbody(double temperature) {
    constexpr double stefan_boltzmann = 5.670374419e-8; // [W/(m² K⁴)]
    Spectrum visible;
    for (double w = first_wavelength; w <= last_wavelength;
         w += 1.0) // [nm]: its curvature is then negligible
        visible.push_back({w, planck(w, temperature)});
    const dvec3 xyz = xyz_of(visible); // [W/m³ nm]
    return {with_unit_luminance(rgb_of_xyz(xyz)),
            lumens_per_watt * 1e-9 * xyz.y / (stefan_boltzmann * std::pow(temperature, 4.0))};
}

} // namespace sr::scene
