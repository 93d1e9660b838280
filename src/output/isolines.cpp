#include "output/isolines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace sr::output {
namespace {

/// A pair of neighbouring centres, numbered through the grid: between them a line crosses at most once.
using Edge = long;

/// Edges that a line joins within one square of four centres.
using Segment = std::pair<Edge, Edge>;

class Contouring {
public:
    Contouring(int columns, int rows, const std::function<double(int, int)>& value, double level)
        : columns_(columns), rows_(rows), value_(value), level_(level) {}

    std::vector<Isoline> lines() {
        for (int row = 0; row + 1 < rows_; ++row)
            for (int column = 0; column + 1 < columns_; ++column) add_square(column, row);
        std::vector<Isoline> lines;
        // Open lines first, from an end that one segment has; the rest are closed.
        for (const bool is_open : {true, false})
            for (std::size_t i = 0; i < segments_.size(); ++i) {
                if (is_taken_[i]) continue;
                const auto [a, b] = segments_[i];
                if (!is_open)
                    lines.push_back(follow(i, a));
                else if (at_edge_[a].size() == 1 || at_edge_[b].size() == 1)
                    lines.push_back(follow(i, at_edge_[a].size() == 1 ? a : b));
            }
        return lines;
    }

private:
    Edge horizontal(int column, int row) const { return 2L * (static_cast<long>(row) * columns_ + column); }
    Edge vertical(int column, int row) const { return horizontal(column, row) + 1; }

    void add(Edge a, Edge b) {
        at_edge_[a].push_back(segments_.size());
        at_edge_[b].push_back(segments_.size());
        segments_.emplace_back(a, b);
        is_taken_.push_back(false);
    }

    void add_square(int column, int row) {
        const std::array<double, 4> corners{value_(column, row), value_(column + 1, row),
                                            value_(column + 1, row + 1), value_(column, row + 1)};
        // Edge i leads from corner i to the next.
        const std::array<Edge, 4> edges{horizontal(column, row), vertical(column + 1, row),
                                        horizontal(column, row + 1), vertical(column, row)};
        const auto is_high = [&](std::size_t i) { return corners[i % 4] >= level_; };
        std::vector<std::size_t> crossed;
        for (std::size_t i = 0; i < 4; ++i)
            if (is_high(i) != is_high(i + 1)) crossed.push_back(i);
        if (crossed.size() == 2) add(edges[crossed[0]], edges[crossed[1]]);
        if (crossed.size() < 4) return;
        const bool middle_is_high = (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0 >= level_;
        // Corners 1 and 3 are cut off where corner 0 is joined to corner 2 through the middle.
        const std::size_t cut = is_high(0) == middle_is_high ? 1 : 0;
        add(edges[(cut + 3) % 4], edges[cut]);
        add(edges[(cut + 1) % 4], edges[(cut + 2) % 4]);
    }

    vec2 crossing(Edge edge) const {
        const int at = static_cast<int>(edge / 2), column = at % columns_, row = at / columns_;
        const bool is_vertical = edge % 2 != 0;
        const double from = value_(column, row),
                     to = is_vertical ? value_(column, row + 1) : value_(column + 1, row);
        const auto part = static_cast<float>((level_ - from) / (to - from));
        return vec2(column, row) + (is_vertical ? vec2(0, part) : vec2(part, 0));
    }

    Isoline follow(std::size_t segment, Edge from) {
        Isoline line{crossing(from)};
        for (Edge at = from;;) {
            is_taken_[segment] = true;
            at = segments_[segment].first == at ? segments_[segment].second : segments_[segment].first;
            line.push_back(crossing(at));
            const std::vector<std::size_t>& next = at_edge_[at];
            const auto free = std::ranges::find_if(next, [&](std::size_t i) { return !is_taken_[i]; });
            if (free == next.end()) return line;
            segment = *free;
        }
    }

    int columns_;
    int rows_;
    const std::function<double(int, int)>& value_;
    double level_;
    std::vector<Segment> segments_;
    std::vector<bool> is_taken_;
    std::map<Edge, std::vector<std::size_t>> at_edge_;
};

} // namespace

std::vector<Isoline> isolines(int columns, int rows, const std::function<double(int, int)>& value,
                              double level) {
    return Contouring(columns, rows, value, level).lines();
}

std::vector<double> round_levels(double min, double max, int count) {
    std::vector<double> levels;
    if (!(max > min) || count < 1) return levels;
    const double finest = (max - min) / (count + 1);
    double step = std::pow(10.0, std::floor(std::log10(finest)));
    for (const double factor : {2.0, 2.5, 2.0})
        if (step < finest) step *= factor;
    for (double i = std::floor(min / step) + 1.0; i * step < max; ++i) levels.push_back(i * step);
    return levels;
}

} // namespace sr::output
