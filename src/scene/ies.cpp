#include "scene/ies.hpp"

#include "core/error.hpp"
#include "core/math.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace sr::scene {
namespace {

/// ∫ (a + b γ) sinγ dγ from g0 to g1 for the line through (g0, I0) and (g1, I1).
double over_gamma(double g0, double I0, double g1, double I1) {
    const double b = g1 > g0 ? (I1 - I0) / (g1 - g0) : 0.0;
    const auto antiderivative = [&](double g) { // of (I0 + b (γ - g0)) sinγ
        return -(I0 + b * (g - g0)) * std::cos(g) + b * std::sin(g);
    };
    return antiderivative(g1) - antiderivative(g0);
}

} // namespace

double flux_of(const LightProfile& profile) {
    const std::size_t rows = profile.gamma.size();
    std::vector<double> columns; // ∫ I sinγ dγ at each φ
    for (std::size_t c = 0; c < profile.phi.size(); ++c) {
        double sum = 0.0;
        for (std::size_t r = 1; r < rows; ++r)
            sum += over_gamma(profile.gamma[r - 1], profile.I[c * rows + r - 1], profile.gamma[r],
                              profile.I[c * rows + r]);
        columns.push_back(sum);
    }
    double flux = 0.0;
    for (std::size_t c = 1; c < columns.size(); ++c)
        flux += 0.5 * (columns[c] + columns[c - 1])
                * (static_cast<double>(profile.phi[c]) - static_cast<double>(profile.phi[c - 1]));
    return flux;
}

namespace {

/// The text of an IES file: lines up to TILT=, then numbers wherever the lines break.
class IesReader {
public:
    IesReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    bool is_at_end() const { return text_.empty(); }
    /// The rest of the current line, without its end.
    std::string_view line();
    /// Returns whether another number (or anything else) follows.
    bool has_more();
    /// The next number, between spaces, commas or line ends. @throws Error calling it `what`
    double number(std::string_view what);
    /// The same, whole and within bounds.
    int whole(std::string_view what, int smallest, int largest);
    std::size_t size_left() const { return text_.size(); }

    /// @throws Error at the line of what was read last
    [[noreturn]] void fail(std::string_view what, std::string_view what_to_do) const;

private:
    void skip_separators();

    std::string_view text_;
    std::string name_;
    int next_line_ = 1; // of text_'s begin
    int line_ = 1;      // of what was read last
};

bool is_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r' || c == '\n' || c == '\0'; }

/// A word of the file in quotes, fit for a message.
std::string shown(std::string_view word) {
    constexpr std::size_t max_length = 40;
    std::string text = "\"";
    for (const char c : word.substr(0, max_length)) text += c >= 0x20 && c < 0x7F ? c : '?';
    return text + (word.size() > max_length ? "…\"" : "\"");
}

std::string_view IesReader::line() {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    line_ = next_line_++;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

void IesReader::skip_separators() {
    while (!text_.empty() && is_separator(text_.front())) {
        next_line_ += text_.front() == '\n';
        text_.remove_prefix(1);
    }
}

bool IesReader::has_more() {
    skip_separators();
    constexpr char dos_end = 0x1A; // ends text files of DOS
    return !text_.empty() && text_.front() != dos_end;
}

double IesReader::number(std::string_view what) {
    const bool is_there = has_more();
    line_ = next_line_;
    if (!is_there) fail(fmt::format("the file ends where {} should be", what), "get the whole file");
    const auto end = std::find_if(text_.begin(), text_.end(), is_separator);
    const std::string_view word(text_.begin(), end);
    text_.remove_prefix(word.size());
    const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
    double value = 0.0;
    const auto [stop, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (failure != std::errc{} || stop != digits.data() + digits.size() || !std::isfinite(value))
        fail(fmt::format("{} is {}, no number", what, shown(word)), "correct it");
    return value;
}

int IesReader::whole(std::string_view what, int smallest, int largest) {
    const double value = number(what);
    if (value != std::floor(value) || value < smallest || value > largest)
        fail(fmt::format("{} is {}", what, value),
             fmt::format("it must be a whole number from {} to {}", smallest, largest));
    return static_cast<int>(value);
}

void IesReader::fail(std::string_view what, std::string_view what_to_do) const {
    throw Error({name_, line_}, what, what_to_do);
}

/// The candela values of a file with all factors, in degrees.
struct IesGrid {
    std::vector<double> vertical;   // ascending, two or more
    std::vector<double> horizontal; // ascending, one or more
    std::vector<double> I;          // [cd]: a column of vertical.size() values for each horizontal angle

    double at(std::size_t v, std::size_t h) const { return I[h * vertical.size() + v]; }
};

constexpr double degree = 3.14159265358979323846 / 180.0; // [rad]

/// Column by horizontal angle of the whole turn, 0 and 360 included.
using Turn = std::map<double, std::size_t>;

std::optional<Turn> whole_turn(const std::vector<double>& horizontal) {
    if (horizontal.size() == 1) return Turn{{0.0, 0}, {360.0, 0}};
    const double first = horizontal.front(), last = horizontal.back();
    const bool is_lateral = first == 90.0 && last == 270.0; // LM-63-1995: symmetric about the plane 90–270
    if (!is_lateral && (first != 0.0 || (last != 90.0 && last < 180.0) || last > 360.0)) return std::nullopt;
    Turn turn;
    for (std::size_t c = 0; c < horizontal.size(); ++c) {
        const double h = horizontal[c];
        turn.emplace(h, c);
        if (is_lateral) turn.emplace(h <= 180.0 ? 180.0 - h : 540.0 - h, c);
        if (!is_lateral && last <= 180.0) turn.emplace(360.0 - h, c);
        if (last == 90.0) {
            turn.emplace(180.0 - h, c);
            turn.emplace(180.0 + h, c);
        }
    }
    turn.emplace(0.0,
                 turn.begin()->second); // a lateral file without the column 180: its neighbours are alike
    turn[360.0] = turn.begin()->second;
    return turn;
}

/// Where a value lies in an ascending list, as index and fraction; absent outside it.
struct Place {
    std::size_t below = 0;
    double fraction = 0.0;
};

std::optional<Place> place_in(const std::vector<double>& list, double value) {
    if (value < list.front() || value > list.back()) return std::nullopt;
    if (list.size() == 1) return Place{};
    const auto above = std::upper_bound(list.begin() + 1, list.end() - 1, value);
    const auto below = static_cast<std::size_t>(above - list.begin()) - 1;
    return Place{below, (value - list[below]) / (list[below + 1] - list[below])};
}

double bilinear(const IesGrid& grid, double v, double h) {
    if (grid.vertical.front() >= 0.0) v = std::abs(v);
    if (grid.horizontal.front() >= 0.0) h = std::abs(h);
    const auto row = place_in(grid.vertical, v);
    const auto column = grid.horizontal.size() == 1 ? Place{} : place_in(grid.horizontal, h);
    if (!row || !column) return 0.0;
    const std::size_t next = std::min(column->below + 1, grid.horizontal.size() - 1);
    const auto along = [&](std::size_t c) {
        return std::lerp(grid.at(row->below, c), grid.at(row->below + 1, c), row->fraction);
    };
    return std::lerp(along(column->below), along(next), column->fraction);
}

/// Type C: vertical 0–180 from photometric zero, horizontal around it. Absent where the horizontal angles end
/// at none of the symmetries.
std::optional<LightProfile> profile_of_type_c(const IesGrid& grid) {
    const auto turn = whole_turn(grid.horizontal);
    if (!turn) return std::nullopt;
    LightProfile profile;
    for (const double v : grid.vertical) profile.gamma.push_back(static_cast<float>(v * degree));
    for (auto column = turn->rbegin(); column != turn->rend(); ++column) { // φ = 360° - H
        profile.phi.push_back(static_cast<float>((360.0 - column->first) * degree));
        for (std::size_t v = 0; v < grid.vertical.size(); ++v)
            profile.I.push_back(static_cast<float>(grid.at(v, column->second)));
    }
    return profile;
}

/// Type B: planes that share the horizontal axis X. A direction is sinV X + cosV (cosH zero - sinH Y), where
/// X, Y and -zero are right-handed (LM-63-2002, section 3, counts H clockwise). What lies beyond the angles
/// is dark; angles from 0 only are completed by symmetry.
LightProfile profile_of_type_b(const IesGrid& grid) {
    constexpr int rows = 181, columns = 181; // by 1° and 2°
    LightProfile profile;
    for (int row = 0; row < rows; ++row) profile.gamma.push_back(static_cast<float>(row * degree));
    for (int column = 0; column < columns; ++column) {
        const double phi = 2.0 * column * degree;
        profile.phi.push_back(static_cast<float>(phi));
        for (int row = 0; row < rows; ++row) {
            const double gamma = row * degree;
            const double x = std::sin(gamma) * std::cos(phi), y = -std::sin(gamma) * std::sin(phi); // φ = -H
            const double v = std::asin(std::clamp(x, -1.0, 1.0)) / degree;
            const double h = std::atan2(-y, std::cos(gamma)) / degree;
            profile.I.push_back(static_cast<float>(bilinear(grid, v, h)));
        }
    }
    return profile;
}

constexpr int max_angles =
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
    const int count = reader.whole("the number of tilt angles", 1, max_angles);
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
    reader.whole("the number of lamps", 1, max_angles);
    reader.number("the lumens of a lamp"); // -1: absolute photometry; the candelas are what counts either way
    lamp.factor = positive(reader, "the candela multiplier");
    lamp.vertical_count = reader.whole("the number of vertical angles", 2, max_angles);
    lamp.horizontal_count = reader.whole("the number of horizontal angles", 1, max_angles);
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
