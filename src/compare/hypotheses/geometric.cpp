#include "compare/hypotheses/hypothesis.hpp"

#include <array>
#include <cmath>
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

std::string half_shift_text(int dx, int dy) {
    std::string text;
    if (dx != 0) text += dx > 0 ? "to the right" : "to the left";
    if (dx != 0 && dy != 0) text += " and ";
    if (dy != 0) text += dy > 0 ? "down" : "up";
    return text;
}

/// Shifts by half a pixel: the mean of the pixels on both sides.
void add_half_shifts(const DiagnosisInput& in, Hypotheses& out) {
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            const double left = residual(in, [&](std::size_t i, std::size_t c) {
                const auto width = static_cast<std::size_t>(in.width);
                const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
                if (x - dx < 0 || y - dy < 0 || x - dx >= in.width || y - dy >= in.height) return unknown;
                const auto r = [&](int u, int v) {
                    const std::size_t at = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
                    return in.known[at] ? in.r(at, c) : unknown;
                };
                return 0.25f * (r(x, y) + r(x - dx, y) + r(x, y - dy) + r(x - dx, y - dy));
            });
            out.push_back(
                {{"shifted",
                  fmt::format("test is the reference shifted by half a pixel: {}", half_shift_text(dx, dy)),
                  left,
                  {}},
                 2});
        }
}

/// Rendered at a fraction of the size and enlarged: each block of pixels is its mean.
void add_blocks(const DiagnosisInput& in, Hypotheses& out) {
    for (const int edge : {2, 3, 4, 8}) {
        const double left = residual(in, [&](std::size_t i, std::size_t c) {
            const auto width = static_cast<std::size_t>(in.width);
            const int x = static_cast<int>(i % width) / edge * edge,
                      y = static_cast<int>(i / width) / edge * edge;
            if (x + edge > in.width || y + edge > in.height) return unknown;
            float sum = 0.0f;
            for (int k = 0; k < edge * edge; ++k)
                sum += in.r(static_cast<std::size_t>(y + k / edge) * width
                                + static_cast<std::size_t>(x + k % edge),
                            c);
            return sum / static_cast<float>(edge * edge);
        });
        out.push_back({{"resolution_scaled",
                        fmt::format("test is the reference at 1/{} of its resolution, enlarged", edge),
                        left,
                        {}},
                       2});
    }
}

} // namespace

void hypotheses_geometric(const DiagnosisInput& in, Hypotheses& out) {
    add_symmetries(in, out);
    add_half_shifts(in, out);
    add_blocks(in, out);
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

namespace {

/// Colours beside an image of one colour, the reference's mean, which replaces the reference: it has no pixel
/// at most of the test's places.
DiagnosisInput input_beside_mean(const image::Image& test, const image::Image& reference) {
    DiagnosisInput in;
    in.width = test.width;
    in.height = test.height;
    in.colors = static_cast<std::size_t>(test.channels);
    in.test = test.pixels;
    const auto count = static_cast<double>(reference.pixels.size() / in.colors);
    std::vector<double> mean(in.colors, 0.0);
    for (std::size_t i = 0; i < reference.pixels.size(); ++i)
        if (std::isfinite(reference.pixels[i]))
            mean[i % in.colors] += static_cast<double>(reference.pixels[i]) / count;
    for (std::size_t i = 0; i < test.pixels.size() / in.colors; ++i) {
        in.pixels.push_back(i);
        for (std::size_t c = 0; c < in.colors; ++c) in.reference.push_back(static_cast<float>(mean[c]));
    }
    for (const double m : mean) in.floor = std::max(in.floor, 0.01f * static_cast<float>(std::abs(m)));
    return in;
}

} // namespace

void hypotheses_turned(const image::Image& test, const image::Image& reference, Hypotheses& out) {
    const DiagnosisInput in = input_beside_mean(test, reference);
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

void hypotheses_resized(const image::Image& test, const image::Image& reference, Hypotheses& out) {
    const DiagnosisInput in = input_beside_mean(test, reference);
    const double scale_x = static_cast<double>(test.width) / reference.width,
                 scale_y = static_cast<double>(test.height) / reference.height;
    // The mean of the reference's pixels whose centres lie in the test's pixel; of a larger test the nearest.
    const auto begin = [](int at, double scale) { return static_cast<int>(std::ceil(at / scale - 0.5)); };
    const double left = residual(in, [&](std::size_t i, std::size_t c) {
        const int x = static_cast<int>(i) % in.width, y = static_cast<int>(i) / in.width;
        const int nearest_x = static_cast<int>((x + 0.5) / scale_x),
                  nearest_y = static_cast<int>((y + 0.5) / scale_y);
        float sum = 0.0f;
        int count = 0;
        for (int v = begin(y, scale_y); v < begin(y + 1, scale_y); ++v)
            for (int u = begin(x, scale_x); u < begin(x + 1, scale_x); ++u, ++count)
                sum += reference.at(u, v)[c];
        return count > 0 ? sum / static_cast<float>(count) : reference.at(nearest_x, nearest_y)[c];
    });
    out.push_back({{"resolution_scaled",
                    fmt::format("test is the reference at {:.4g} times its width and {:.4g} times its height",
                                scale_x, scale_y),
                    left,
                    {}},
                   2});
}

} // namespace sr::compare
