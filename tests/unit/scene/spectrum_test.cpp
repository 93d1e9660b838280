#include "scene/spectrum.hpp"

#include "scene/units.hpp"
#include "support/address.hpp"

#include <cmath>

using namespace sr;
using namespace sr::scene;
using sr::testing::Test;

namespace {

glm::dvec2 chromaticity(glm::dvec3 xyz) { return glm::dvec2(xyz) / (xyz.x + xyz.y + xyz.z); }

glm::dvec2 chromaticity_of_blackbody(double temperature) {
    Spectrum spectrum;
    for (double w = 360.0; w <= 830.0; w += 1.0) spectrum.push_back({w, planck(w, temperature)});
    return chromaticity(xyz_of(spectrum));
}

/// Linear Rec. 709 → XYZ: the primaries' columns for a D65 white, ITU-R BT.709-6 and IEC 61966-2-1.
glm::dvec2 chromaticity_of_rgb(vec3 rgb) {
    const glm::dmat3 xyz_from_rgb(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375,
                                  0.0721750, 0.9503041);
    return chromaticity(xyz_from_rgb * glm::dvec3(rgb));
}

void expect_chromaticity(glm::dvec2 found, double x, double y, double tolerance) {
    EXPECT_NEAR(found.x, x, tolerance);
    EXPECT_NEAR(found.y, y, tolerance);
}

// CIE 15:2004: illuminant A is a black body of 2856 K (with c₂ = 1.4388e-2). The others by the 1 nm tables.
const Test blackbodies("unit.scene.spectrum.chromaticities_of_black_bodies", [] {
    expect_chromaticity(chromaticity_of_blackbody(2856.0), 0.4476, 0.4074, 1e-4);
    expect_chromaticity(chromaticity_of_blackbody(4000.0), 0.38044, 0.37675, 5e-5);
    expect_chromaticity(chromaticity_of_blackbody(6504.0), 0.31346, 0.32357, 5e-5);
    expect_chromaticity(chromaticity_of_blackbody(10000.0), 0.28063, 0.28829, 5e-5);
});

const Test equal_energy("unit.scene.spectrum.equal_energy_is_at_a_third", [] {
    const Spectrum flat{{360.0, 1.0}, {830.0, 1.0}};
    expect_chromaticity(chromaticity(xyz_of(flat)), 1.0 / 3.0, 1.0 / 3.0,
                        5e-5);                  // the CIE's tables miss it by that
    EXPECT_NEAR(xyz_of(flat).y, 106.857, 1e-3); // Σ ȳ of the CIE's 1 nm table
});

// Relative power of D65, CIE 15:2004, table T.1, by 20 nm: enough for three digits of its white.
const Test daylight("unit.scene.spectrum.d65_is_white", [] {
    const Spectrum d65{{380, 49.9755}, {400, 82.7549}, {420, 93.4318}, {440, 104.865}, {460, 117.812},
                       {480, 115.923}, {500, 109.354}, {520, 104.790}, {540, 104.405}, {560, 100.0},
                       {580, 95.788},  {600, 90.0062}, {620, 87.6987}, {640, 83.6992}, {660, 80.2146},
                       {680, 78.2842}, {700, 71.6091}, {720, 61.604},  {740, 75.087},  {760, 46.4182},
                       {780, 63.3828}};
    expect_chromaticity(chromaticity(xyz_of(d65)), 0.3127, 0.3290, 2e-3);
    const vec3 rgb = color_of(d65).rgb;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(rgb[i], 1.0f, 0.03f);
});

const Test in_rgb("unit.scene.spectrum.rgb_has_luminance_1_and_the_spectrum's_chromaticity", [] {
    for (const double temperature : {2200.0, 2856.0, 6504.0, 20000.0}) {
        const LightColor color = color_of_blackbody(temperature);
        EXPECT_NEAR(scene::luminance(color.rgb), 1.0, 1e-6);
        const glm::dvec2 expected = chromaticity_of_blackbody(temperature);
        expect_chromaticity(chromaticity_of_rgb(color.rgb), expected.x, expected.y, 1e-4);
    }
});

// A spectral line is outside Rec. 709: no component is negative, and the luminance stays.
const Test line("unit.scene.spectrum.a_laser_is_clipped_to_the_gamut", [] {
    const vec3 rgb = color_of({{509.0, 0.0}, {510.0, 1.0}, {511.0, 0.0}}).rgb;
    EXPECT_EQ(rgb.r, 0.0f);
    EXPECT_GT(rgb.g, 1.0f);
    EXPECT_GE(rgb.b, 0.0f);
    EXPECT_NEAR(scene::luminance(rgb), 1.0, 1e-6);
});

// 683 lm/W at the peak of V(λ); black bodies by the 1 nm table against σT⁴.
const Test efficacy("unit.scene.spectrum.efficacies", [] {
    EXPECT_NEAR(color_of({{554.9, 0.0}, {555.0, 1.0}, {555.1, 0.0}}).efficacy, 683.0, 0.5);
    EXPECT_NEAR(color_of_blackbody(2856.0).efficacy, 16.446, 0.01);
    EXPECT_NEAR(color_of_blackbody(6504.0).efficacy, 95.367, 0.05);
});

const Test table("unit.scene.observer.rows_and_lines_between", [] {
    EXPECT_NEAR(observer(555.0).y, 1.0, 1e-6);
    EXPECT_NEAR(observer(450.0).z, 1.77211, 1e-6);
    EXPECT_NEAR(observer(552.5).y, 0.5 * (observer(550.0).y + observer(555.0).y), 1e-9);
    EXPECT_EQ(observer(830.1), glm::dvec3(0.0));
    EXPECT_EQ(observer(359.9), glm::dvec3(0.0));
    EXPECT_GT(observer(830.0).y, 0.0);
});

const Test units("unit.scene.units.names_both_ways", [] {
    for (const NamedUnit& named : unit_names) {
        EXPECT_EQ(unit_named(named.name), named.unit);
        EXPECT_EQ(unit_named(name_of(named.unit)), named.unit);
    }
    EXPECT_FALSE(unit_named("lumen"));
    EXPECT_FALSE(unit_named("LM"));
    EXPECT_EQ(radiance_unit(UnitSystem::photometric), "cd/m^2");
    EXPECT_EQ(radiance_unit(UnitSystem::radiometric), "W/(m^2 sr)");
});

} // namespace
