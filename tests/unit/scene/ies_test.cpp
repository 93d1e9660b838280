#include "scene/ies.hpp"

#include "core/error.hpp"
#include "scene/spectrum.hpp"
#include "support/address.hpp"

#include <cmath>
#include <fmt/format.h>

using namespace sr;
using namespace sr::scene;
using sr::testing::Test;

namespace {

constexpr double degree = 3.14159265358979323846 / 180.0;

/// Numbers of a file with `vertical` and `horizontal` angles, after the line TILT=NONE.
std::string file(const std::string& vertical, int vertical_count, const std::string& horizontal,
                 int horizontal_count, const std::string& candelas,
                 const std::string& rest = "1 2 0 0 0\n1 1 10") {
    return fmt::format("IESNA:LM-63-2002\n[TEST] none\nTILT=NONE\n1 -1 1 {} {} {}\n{}\n{}\n{}\n",
                       vertical_count, horizontal_count, rest, vertical, horizontal, candelas);
}

/// I of a profile in the direction of vertical angle v and horizontal angle h [deg]: its φ runs against h.
double intensity(const LightProfile& profile, double v, double h) {
    const auto place = [](const std::vector<float>& list, double value) {
        std::size_t i = 0;
        while (i + 2 < list.size() && list[i + 1] < value) ++i;
        return std::pair{i, (value - list[i]) / (list[i + 1] - list[i])};
    };
    const auto [r, fr] = place(profile.gamma, v * degree);
    const auto [c, fc] = place(profile.phi, (h == 0.0 ? 0.0 : 360.0 - h) * degree);
    const auto at = [&](std::size_t column, std::size_t row) {
        return double(profile.I[column * profile.gamma.size() + row]);
    };
    return std::lerp(std::lerp(at(c, r), at(c, r + 1), fr), std::lerp(at(c + 1, r), at(c + 1, r + 1), fr),
                     fc);
}

std::string error_of(const std::string& text) {
    try {
        read_ies(text, "lamp.ies");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

const Test isotropic("unit.scene.ies.an_isotropic_file_is_a_point_light", [] {
    const LightProfile profile = read_ies(file("0 90 180", 3, "0", 1, "7 7 7"), "lamp.ies").profile;
    for (const double v : {0.0, 33.0, 90.0, 140.0, 180.0})
        for (const double h : {0.0, 45.0, 200.0, 359.0}) EXPECT_NEAR(intensity(profile, v, h), 7.0, 1e-5);
    EXPECT_NEAR(flux_of(profile), 4.0 * 180.0 * degree * 7.0, 1e-4);
    EXPECT_EQ(profile.phi.front(), 0.0f);
    EXPECT_NEAR(profile.phi.back(), 2.0f * pi, 1e-6f);
});

// The flux of what the linear interpolation says, by the midpoint rule.
const Test flux("unit.scene.ies.flux_is_the_integral", [] {
    const std::string text = file("0 20 50 90", 4, "0 30 180 250 360", 5,
                                  "90 70 40 5 80 60 45 2 20 10 5 1 40 50 60 70 90 70 40 5");
    const LightProfile profile = read_ies(text, "lamp.ies").profile;
    double sum = 0.0;
    constexpr int rows = 360, columns = 720;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double v = 90.0 * (i + 0.5) / rows, h = 360.0 * (j + 0.5) / columns;
            sum += intensity(profile, v, h) * std::sin(v * degree) * (90.0 / rows) * (360.0 / columns);
        }
    EXPECT_NEAR(flux_of(profile), sum * degree * degree, 1e-4 * flux_of(profile));
});

const Test symmetries("unit.scene.ies.symmetries", [] {
    const auto profile = [](const char* horizontal, int count, const char* candelas) {
        return read_ies(file("0 90", 2, horizontal, count, candelas), "lamp.ies").profile;
    };
    const LightProfile quadrant = profile("0 45 90", 3, "1 10 1 20 1 30");
    for (const double h : {45.0, 135.0, 225.0, 315.0}) EXPECT_NEAR(intensity(quadrant, 90, h), 20.0, 1e-4);
    EXPECT_NEAR(intensity(quadrant, 90, 180), 10.0, 1e-4);
    EXPECT_NEAR(intensity(quadrant, 90, 270), 30.0, 1e-4);
    const LightProfile half = profile("0 90 180", 3, "1 10 1 20 1 30");
    EXPECT_NEAR(intensity(half, 90, 90), 20.0, 1e-4);
    EXPECT_NEAR(intensity(half, 90, 270), 20.0, 1e-4);
    EXPECT_NEAR(intensity(half, 90, 180), 30.0, 1e-4);
    const LightProfile whole = profile("0 90 180 270 360", 5, "1 10 1 20 1 30 1 40 1 10");
    EXPECT_NEAR(intensity(whole, 90, 90), 20.0, 1e-4);
    EXPECT_NEAR(intensity(whole, 90, 270), 40.0, 1e-4);
    EXPECT_NEAR(intensity(whole, 45, 270), 20.5, 1e-4);
    const LightProfile open = profile("0 120 240", 3, "1 10 1 20 1 30"); // not closed by a column at 360
    EXPECT_NEAR(intensity(open, 90, 240), 30.0, 1e-4);
    EXPECT_NEAR(intensity(open, 90, 300), 20.0, 1e-4);
    const LightProfile lateral = profile("90 135 180 225 270", 5, "1 10 1 20 1 30 1 40 1 50");
    EXPECT_NEAR(intensity(lateral, 90, 0), 30.0, 1e-4);
    EXPECT_NEAR(intensity(lateral, 90, 45), 20.0, 1e-4);
    EXPECT_NEAR(intensity(lateral, 90, 315), 40.0, 1e-4);
});

const Test factors("unit.scene.ies.all_factors_count", [] {
    const auto first = [](const char* head, const char* numbers) {
        const std::string text =
            fmt::format("{}TILT=NONE\r\n2 1000 3 2 1 {}\r\n0,90\r\n0\r\n10, 5\r\n\x1A", head, numbers);
        return read_ies(text, "lamp.ies").profile.I.at(0);
    };
    EXPECT_FLOAT_EQ(first("IESNA:LM-63-1995\r\n", "1 1 0 0 0 0.5 0.25 30"), 15.0f); // 0.25 is for future use
    EXPECT_FLOAT_EQ(first("IESNA91\r\n", "1 1 0 0 0 0.5 0.25 30"), 3.75f);
    EXPECT_FLOAT_EQ(first("An old lamp\r\n", "1 1 0 0 0 0.5 0.25 30"), 3.75f); // 1986 has no first line
});

const Test tilt("unit.scene.ies.tilt_factors", [] {
    const auto with_geometry = [](int geometry) {
        const std::string text = fmt::format("IESNA:LM-63-2002\nTILT=INCLUDE\n{}\n3\n0 45 90\n1 0.9 0.5\n1 "
                                             "-1 1 2 1 1 2 0 0 0\n1 1 1\n0 90\n0\n10 5\n",
                                             geometry);
        return *read_ies(text, "lamp.ies").tilt;
    };
    EXPECT_DOUBLE_EQ(tilt_factor(with_geometry(1), 0.0), 1.0);
    EXPECT_NEAR(tilt_factor(with_geometry(1), 22.5 * degree), 0.95, 1e-12);
    EXPECT_NEAR(tilt_factor(with_geometry(3), 67.5 * degree), 0.7, 1e-12);
    EXPECT_DOUBLE_EQ(tilt_factor(with_geometry(3), 170 * degree), 0.5);
    EXPECT_DOUBLE_EQ(tilt_factor(with_geometry(2), 67.5 * degree), 1.0) << "a lamp that stays lying";
});

// Type B: a beam at V = 30° along X and H = 0; one at H = 60° turns from zero towards -Y, which is h = 270°.
const Test type_b("unit.scene.ies.type_b_is_turned_into_type_c", [] {
    const std::string head = "2 2 0 0 0\n1 1 10";
    const LightProfile along =
        read_ies(file("-90 29 30 31 90", 5, "0", 1, "0 0 100 0 0", head), "lamp.ies").profile;
    EXPECT_NEAR(intensity(along, 30, 0), 100.0, 1e-3);
    EXPECT_NEAR(intensity(along, 30, 180), 0.0, 1e-3);
    const LightProfile across =
        read_ies(file("-90 0 90", 3, "-90 59 60 61 90", 5, "0 0 0 0 0 0 0 80 0 0 0 0 0 0 0", head),
                 "lamp.ies")
            .profile;
    EXPECT_NEAR(intensity(across, 60, 270), 80.0, 1e-3);
    EXPECT_NEAR(intensity(across, 60, 90), 0.0, 1e-3);
    const LightProfile mirrored =
        read_ies(file("0 90", 2, "0 90", 2, "50 50 50 50", head), "lamp.ies").profile;
    for (const double h : {0.0, 90.0, 180.0, 270.0}) EXPECT_NEAR(intensity(mirrored, 40, h), 50.0, 1e-3);
    EXPECT_NEAR(flux_of(mirrored), 100.0 * 180.0 * degree, 0.01 * 100.0 * 180.0 * degree); // 50 cd over 2π sr
    EXPECT_NEAR(intensity(mirrored, 120, 0), 0.0, 1e-3);
});

const Test broken("unit.scene.ies.a_broken_file_is_one_line_with_its_line_number", [] {
    EXPECT_EQ(error_of(""), "lamp.ies:1: there is no line that begins with TILT=: give an IES LM-63 file");
    EXPECT_EQ(error_of("IESNA:LM-63-2002\nTILT=lamp.tlt\n"),
              "lamp.ies:2: the tilt factors are in another file: put them into this one, as TILT=INCLUDE");
    EXPECT_EQ(error_of(file("0 90", 2, "0", 1, "7 -7")),
              "lamp.ies:8: a candela value is -7: give zero or more, as a 32-bit float can say it");
    EXPECT_EQ(error_of(file("0 90", 2, "0", 1, "7 seven")),
              "lamp.ies:8: a candela value is \"seven\", no number: correct it");
    EXPECT_EQ(error_of(file("0 90", 2, "0", 1, "7 nan")),
              "lamp.ies:8: a candela value is \"nan\", no number: correct it");
    EXPECT_EQ(error_of(file("0 90", 2, "0", 1, "7 1e60")),
              "lamp.ies:8: a candela value is 1e+60: give zero or more, as a 32-bit float can say it");
    EXPECT_NE(error_of(file("0 90", 2, "0", 1, "7")).find("the file ends where a candela value should be"),
              std::string::npos);
    EXPECT_NE(error_of(file("0 90", 2, "0", 1, "7 7 7")).find("lamp.ies:8: more numbers follow"),
              std::string::npos);
    EXPECT_NE(error_of(file("90 0", 2, "0", 1, "7 7")).find("lamp.ies:6: a vertical angle is 0 after 90"),
              std::string::npos);
    EXPECT_NE(error_of(file("0 190", 2, "0", 1, "7 7")).find("between 0 and 180 degrees"), std::string::npos);
    EXPECT_NE(error_of(file("0 90", 2, "0 45", 2, "7 7 7 7")).find("the horizontal angles go from 0 to 45"),
              std::string::npos);
    EXPECT_NE(error_of(file("0 90", 2, "0", 1, "7 7", "3 2 0 0 0\n1 1 1")).find("type A photometry"),
              std::string::npos);
    EXPECT_NE(error_of(file("0 90", 2, "0", 1, "7 7", "1 2 0 0 0\n0 1 1")).find("the ballast factor is 0"),
              std::string::npos);
    EXPECT_NE(error_of(file("0 90", 90000, "0", 90000, "7 7")).find("more than the file can hold"),
              std::string::npos);
});

} // namespace
