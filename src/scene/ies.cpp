#include "scene/ies.hpp"

#include "core/math.hpp"
#include "scene/ies_grid.hpp"
#include "scene/ies_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace sr::scene {
namespace {

constexpr int most_angles =
    100'000; // far more than a goniometer stops at; the values must be in the file anyway

/// The part of the file before the numbers.
struct Head {
    bool has_lamp_factor = true; // the editions of 1986 and 1991 have a ballast-lamp photometric factor
    bool has_tilt = false;
};

Head read_head(IesReader& reader) {
    Head head;
    bool is_first = true;
    while (!reader.is_at_end()) {
        const std::string_view line = reader.line();
        if (is_first && (line.starts_with("IESNA:LM-63-") || line.starts_with("IES:LM-63-")))
            head.has_lamp_factor = false;
        is_first = false;
        if (!line.starts_with("TILT=")) continue;
        std::string_view value = line.substr(5);
        while (value.ends_with(' ') || value.ends_with('\t')) value.remove_suffix(1);
        head.has_tilt = value == "INCLUDE";
        if (head.has_tilt || value == "NONE") return head;
        reader.fail("the tilt factors are in another file", "put them into this one, as TILT=INCLUDE");
    }
    reader.fail("there is no line that begins with TILT=", "give an IES LM-63 file");
}

std::vector<double> ascending(IesReader& reader, int count, const char* what, double smallest,
                              double largest) {
    std::vector<double> angles;
    for (int i = 0; i < count; ++i) {
        const double angle = reader.number(what);
        if (!(angle >= smallest && angle <= largest))
            reader.fail(fmt::format("{} is {}", what, angle),
                        fmt::format("it must be between {} and {} degrees", smallest, largest));
        if (!angles.empty() && !(angle > angles.back()))
            reader.fail(fmt::format("{} is {} after {}", what, angle, angles.back()), "angles must ascend");
        angles.push_back(angle);
    }
    return angles;
}

IesTilt read_tilt(IesReader& reader) {
    IesTilt tilt;
    tilt.geometry = static_cast<IesTilt::Geometry>(reader.whole("the lamp-to-luminaire geometry", 1, 3));
    const int count = reader.whole("the number of tilt angles", 1, most_angles);
    for (const double angle : ascending(reader, count, "a tilt angle", 0.0, 180.0))
        tilt.angles.push_back(glm::radians(angle));
    for (int i = 0; i < count; ++i) {
        tilt.factors.push_back(reader.number("a tilt factor"));
        if (!(tilt.factors.back() >= 0.0))
            reader.fail(fmt::format("a tilt factor is {}", tilt.factors.back()), "give zero or more");
    }
    return tilt;
}

double positive(IesReader& reader, const char* what) {
    const double value = reader.number(what);
    if (!(value > 0.0)) reader.fail(fmt::format("{} is {}", what, value), "give a positive one, 1 for none");
    return value;
}

/// The line of ten and that of three numbers.
struct Lamp {
    double factor = 1.0; // of all candela values
    int vertical_count = 0;
    int horizontal_count = 0;
    bool is_type_b = false;
};

Lamp read_lamp(IesReader& reader, const Head& head) {
    Lamp lamp;
    reader.whole("the number of lamps", 1, most_angles);
    reader.number("the lumens of a lamp"); // -1: absolute photometry; the candelas are what counts either way
    lamp.factor = positive(reader, "the candela multiplier");
    lamp.vertical_count = reader.whole("the number of vertical angles", 2, most_angles);
    lamp.horizontal_count = reader.whole("the number of horizontal angles", 1, most_angles);
    const int type = reader.whole("the photometric type", 1, 3);
    if (type == 3)
        reader.fail("this is type A photometry, and only types B and C are read", "convert it to type C");
    lamp.is_type_b = type == 2;
    reader.whole("the type of units", 1, 2);
    for (const char* what : {"the width", "the length", "the height"}) reader.number(what);
    lamp.factor *= positive(reader, "the ballast factor");
    // From 1995 on the second factor is kept "for future use".
    if (head.has_lamp_factor)
        lamp.factor *= positive(reader, "the ballast-lamp photometric factor");
    else
        reader.number("the number for future use");
    reader.number("the input watts");
    return lamp;
}

IesGrid read_grid(IesReader& reader, const Lamp& lamp) {
    const auto values =
        static_cast<std::size_t>(lamp.vertical_count) * static_cast<std::size_t>(lamp.horizontal_count);
    if (values > reader.size_left())
        reader.fail(fmt::format("{} candela values are announced, more than the file can hold", values),
                    "correct the numbers of angles");
    IesGrid grid;
    grid.vertical = ascending(reader, lamp.vertical_count, "a vertical angle", lamp.is_type_b ? -90.0 : 0.0,
                              lamp.is_type_b ? 90.0 : 180.0);
    grid.horizontal = ascending(reader, lamp.horizontal_count, "a horizontal angle",
                                lamp.is_type_b ? -90.0 : 0.0, lamp.is_type_b ? 90.0 : 360.0);
    for (std::size_t i = 0; i < values; ++i) {
        const double I = reader.number("a candela value") * lamp.factor;
        if (!(I >= 0.0 && std::isfinite(static_cast<float>(I))))
            reader.fail(fmt::format("a candela value is {}", I),
                        "give zero or more, as a 32-bit float can say it");
        grid.I.push_back(I);
    }
    return grid;
}

} // namespace

IesLuminaire read_ies(std::string_view text, const std::string& name) {
    IesReader reader(text, name);
    const Head head = read_head(reader);
    IesLuminaire luminaire;
    if (head.has_tilt) luminaire.tilt = read_tilt(reader);
    const Lamp lamp = read_lamp(reader, head);
    const IesGrid grid = read_grid(reader, lamp);
    auto profile = lamp.is_type_b ? profile_of_type_b(grid) : profile_of_type_c(grid);
    if (!profile)
        reader.fail(fmt::format("the horizontal angles go from {} to {}", grid.horizontal.front(),
                                grid.horizontal.back()),
                    "they must be 0 alone, 0 to 90, 0 to 180, 0 to 360, or 90 to 270 degrees");
    if (reader.has_more()) {
        reader.number("what follows the last candela value");
        reader.fail("more numbers follow than the numbers of angles ask for", "correct these numbers");
    }
    luminaire.profile = *std::move(profile);
    luminaire.profile.name = name;
    return luminaire;
}

double tilt_factor(const IesTilt& tilt, double angle) {
    if (tilt.geometry == IesTilt::Geometry::stays_lying) angle = 0.0;
    const auto above = std::upper_bound(tilt.angles.begin(), tilt.angles.end(), angle);
    if (above == tilt.angles.begin()) return tilt.factors.front();
    if (above == tilt.angles.end()) return tilt.factors.back();
    const auto i = static_cast<std::size_t>(above - tilt.angles.begin());
    return std::lerp(tilt.factors[i - 1], tilt.factors[i],
                     (angle - tilt.angles[i - 1]) / (tilt.angles[i] - tilt.angles[i - 1]));
}

} // namespace sr::scene
