#include "scene/ies_grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace sr::scene {
namespace {

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

} // namespace

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

} // namespace sr::scene
