#include "compare/hypotheses/hypothesis.hpp"

#include <array>
#include <cstdlib>
#include <fmt/format.h>

namespace sr::compare {
namespace {

constexpr int max_shift = 2; // [pixels]

struct Place {
    int x = 0;
    int y = 0;
};

/// The reference read at another place for each pixel; outside it nothing is known.
template<typename Where>
double residual_of_place(const DiagnosisInput& in, const Where& where) {
    return residual(in, [&](std::size_t i, std::size_t c) {
        const auto width = static_cast<std::size_t>(in.width);
        const Place from = where(static_cast<int>(i % width), static_cast<int>(i / width));
        if (from.x < 0 || from.y < 0 || from.x >= in.width || from.y >= in.height) return unknown;
        const std::size_t source =
            static_cast<std::size_t>(from.y) * width + static_cast<std::size_t>(from.x);
        return in.known[source] ? in.r(source, c) : unknown;
    });
}

struct Symmetry {
    const char* name;
    const char* statement;
    bool transposes;
    bool flips_x; // of the reference's place, after transposing
    bool flips_y;
};

constexpr std::array symmetries{
    Symmetry{"flipped_x", "test is the reference mirrored left to right", false, true, false},
    Symmetry{"flipped_y", "test is the reference upside down (rows in the other order)", false, false, true},
    Symmetry{"rotated_180", "test is the reference turned by 180°", false, true, true},
    Symmetry{"transposed", "test is the reference with rows and columns swapped", true, false, false},
    Symmetry{"rotated_90", "test is the reference turned by 90° clockwise", true, false, true},
    Symmetry{"rotated_270", "test is the reference turned by 90° anticlockwise", true, true, false},
    Symmetry{"transposed_180", "test is the reference mirrored along its other diagonal", true, true, true}};

void add_symmetries(const DiagnosisInput& in, Hypotheses& out) {
    for (const Symmetry& s : symmetries) {
        if (s.transposes && in.width != in.height) continue;
        const double left = residual_of_place(in, [&](int x, int y) {
            const Place p = s.transposes ? Place{y, x} : Place{x, y};
            return Place{s.flips_x ? in.width - 1 - p.x : p.x, s.flips_y ? in.height - 1 - p.y : p.y};
        });
        out.push_back({{s.name, s.statement, left, {}}, 1});
    }
}

std::string shift_text(int dx, int dy) {
    std::string text;
    if (dx != 0) text += fmt::format("{} to the {}", std::abs(dx), dx > 0 ? "right" : "left");
    if (dx != 0 && dy != 0) text += " and ";
    if (dy != 0) text += fmt::format("{} {}", std::abs(dy), dy > 0 ? "down" : "up");
    return text;
}

} // namespace

void hypotheses_geometric(const DiagnosisInput& in, Hypotheses& out) {
    add_symmetries(in, out);
    for (int dy = -max_shift; dy <= max_shift; ++dy)
        for (int dx = -max_shift; dx <= max_shift; ++dx) {
            if (dx == 0 && dy == 0) continue;
            const double left = residual_of_place(in, [dx, dy](int x, int y) {
                return Place{x - dx, y - dy};
            });
            out.push_back({{"shifted",
                            fmt::format("test is the reference shifted by pixels: {}", shift_text(dx, dy)),
                            left,
                            {}},
                           2});
        }
}

void hypotheses_turned(const image::Image& test, const image::Image& reference, Hypotheses& out) {
    // The mean replaces the reference, which has no pixel at most of the test's places.
    DiagnosisInput in;
    in.width = test.width;
    in.height = test.height;
    in.colors = static_cast<std::size_t>(test.channels);
    in.test = test.pixels;
    const std::size_t count = test.pixels.size() / in.colors;
    std::vector<double> mean(in.colors, 0.0);
    for (std::size_t i = 0; i < reference.pixels.size(); ++i)
        if (std::isfinite(reference.pixels[i]))
            mean[i % in.colors] += static_cast<double>(reference.pixels[i]) / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) {
        in.pixels.push_back(i);
        for (std::size_t c = 0; c < in.colors; ++c) in.reference.push_back(static_cast<float>(mean[c]));
    }
    for (const double m : mean) in.floor = std::max(in.floor, 0.01f * static_cast<float>(std::abs(m)));
    for (const Symmetry& s : symmetries) {
        if (!s.transposes) continue;
        const double left = residual(in, [&](std::size_t i, std::size_t c) {
            const int x = static_cast<int>(i) % in.width, y = static_cast<int>(i) / in.width;
            const int from_x = s.flips_x ? reference.width - 1 - y : y,
                      from_y = s.flips_y ? reference.height - 1 - x : x;
            return reference.at(from_x, from_y)[c];
        });
        out.push_back({{s.name, s.statement, left, {}}, 1});
    }
}

} // namespace sr::compare
