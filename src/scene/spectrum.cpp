#include "scene/spectrum.hpp"

#include "scene/observer.hpp"

#include <algorithm>
#include <cmath>

namespace sr::scene {
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
