#include "scene/measured_brdf.hpp"

#include "core/error.hpp"
#include "scene/spectrum.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>

namespace sr::scene {
namespace {

static_assert(std::endian::native == std::endian::little,
              "MERL files are little-endian, and read as they are");

// The database's own reader (BRDFRead.cpp, 2006).
constexpr std::array<double, 3> scales{1.0 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};
constexpr std::array<std::int32_t, 3> dimensions{merl_half_angles, merl_difference_angles, merl_azimuths};
constexpr std::size_t header_size = sizeof(dimensions);
constexpr std::size_t file_size = header_size + 3 * merl_cells * sizeof(double);

double half_angle(double index) { return 0.5 * glm::pi<double>() * std::pow(index / merl_half_angles, 2.0); }

/// D(θ) / D(0) = 1/2 solved for α: with s = sinθ, c = cosθ, s² + α² c² = √2 α².
float fitted_alpha(const std::vector<vec3>& values) {
    const auto at = [&](int i) { // at φd = θd = 0: retroreflection, where the lobe stands alone
        return luminance(values[static_cast<std::size_t>(i) * merl_difference_angles * merl_azimuths]);
    };
    double peak = 0.0;
    for (int i = 0; i < merl_half_angles; ++i) peak = std::max(peak, at(i));
    int fallen = 0;
    constexpr int far_off = 64; // θh = 46°: what is left there is no part of a peak
    const double half = 0.5 * (peak + std::min(peak, at(far_off)));
    while (fallen < merl_half_angles - 1 && at(fallen) > half) ++fallen;
    const double theta = half_angle(fallen + 0.5), s2 = std::pow(std::sin(theta), 2.0);
    const double room = std::sqrt(2.0) - (1.0 - s2);
    return static_cast<float>(std::clamp(std::sqrt(s2 / room), 1e-3, 1.0));
}

} // namespace

std::pair<vec3, vec3> merl_directions(std::size_t cell) {
    constexpr double pi = glm::pi<double>();
    const double phi_d = pi * (static_cast<double>(cell % merl_azimuths) + 0.5) / merl_azimuths;
    const std::size_t row = cell / merl_azimuths;
    const double theta_d =
        0.5 * pi * (static_cast<double>(row % merl_difference_angles) + 0.5) / merl_difference_angles;
    const double theta_h = half_angle(static_cast<double>(row / merl_difference_angles) + 0.5);
    // Around h, then h around y, away from n (Rusinkiewicz 1998, section 3).
    const glm::dvec3 d(std::sin(theta_d) * std::cos(phi_d), std::sin(theta_d) * std::sin(phi_d),
                       std::cos(theta_d));
    const auto tilted = [&](glm::dvec3 v) {
        return vec3(std::cos(theta_h) * v.x + std::sin(theta_h) * v.z, v.y,
                    std::cos(theta_h) * v.z - std::sin(theta_h) * v.x);
    };
    return {tilted(d), tilted(glm::dvec3(-d.x, -d.y, d.z))};
}

MeasuredBrdf read_merl(std::span<const std::byte> file, const std::string& name) {
    constexpr auto remedy = "give a file of the MERL BRDF database: 90 × 90 × 180 cells";
    std::array<std::int32_t, 3> counts{};
    if (file.size() >= header_size) std::memcpy(counts.data(), file.data(), header_size);
    if (file.size() < header_size || counts != dimensions)
        throw Error({name}, "not a measured BRDF in MERL's binary format", remedy);
    if (file.size() != file_size)
        throw Error({name}, fmt::format("{} bytes, where its header asks for {}", file.size(), file_size),
                    "fetch it again: it seems to be cut short or damaged");
    MeasuredBrdf brdf{name, std::vector<vec3>(merl_cells), 1.0f};
    for (int channel = 0; channel < 3; ++channel) {
        const std::byte* plane =
            file.data() + header_size + static_cast<std::size_t>(channel) * merl_cells * sizeof(double);
        for (std::size_t i = 0; i < merl_cells; ++i) {
            double value = 0.0;
            std::memcpy(&value, plane + i * sizeof(double), sizeof(double));
            if (!std::isfinite(value)) throw Error({name}, fmt::format("cell {} is not finite", i), remedy);
            brdf.values[i][channel] =
                static_cast<float>(std::max(0.0, value * scales[static_cast<std::size_t>(channel)]));
        }
    }
    brdf.alpha = fitted_alpha(brdf.values);
    return brdf;
}

std::vector<std::byte> merl_file(std::span<const vec3> values) {
    require(values.size() == merl_cells, "there is a value for each cell");
    std::vector<std::byte> file(file_size);
    std::memcpy(file.data(), dimensions.data(), header_size);
    std::byte* place = file.data() + header_size;
    for (int channel = 0; channel < 3; ++channel)
        for (const vec3 value : values) {
            const double stored =
                static_cast<double>(value[channel]) / scales[static_cast<std::size_t>(channel)];
            std::memcpy(place, &stored, sizeof(double));
            place += sizeof(double);
        }
    return file;
}

} // namespace sr::scene
