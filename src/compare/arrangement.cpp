#include "compare/arrangement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace sr::compare {
namespace {

/// The distribution of chi-squared (Abramowitz & Stegun 1964, Eq. 26.4.4 and 6.5.29).
double chi_squared_below(double value, double degrees) {
    const double a = degrees / 2.0, x = value / 2.0;
    if (x <= 0.0) return 0.0;
    double term = std::exp(a * std::log(x) - x - std::lgamma(a + 1.0)), sum = term;
    for (double n = 1.0; term > 1e-12 * sum; ++n) sum += term *= x / (a + n);
    return std::min(sum, 1.0);
}

bool are_in_rhythm(const std::vector<std::size_t>& places) {
    std::size_t run = 1;
    for (std::size_t k = 1; k < places.size(); ++k) {
        const std::size_t distance = places[k] - places[k - 1];
        run = k > 1 && distance == places[k - 1] - places[k - 2] ? run + 1 : 2;
        const bool are_all = run == places.size() && distance > 1; // those of a cluster touch
        if (run > (are_all ? max_in_rhythm : max_in_rhythm_of_more)
            && (are_all || distance >= min_distance_in_rhythm))
            return true;
    }
    return false;
}

} // namespace

double chance_of_evenness(const std::vector<std::size_t>& places) {
    double sum = 0.0, logarithms = 0.0, count = 0.0;
    std::size_t start = 0; // of the last places that touch
    for (std::size_t k = 1; k < places.size(); ++k) {
        if (places[k] - places[k - 1] == 1) continue;
        const auto between = static_cast<double>(places[k] - places[start] - 1);
        sum += between;
        logarithms += std::log(between);
        ++count;
        start = k;
    }
    if (count < 2.0 || sum + count < min_distance_of_evenness * count) return 1.0;
    const double bartlett =
        2.0 * count * (std::log(sum / count) - logarithms / count) / (1.0 + (count + 1.0) / (6.0 * count));
    return chi_squared_below(bartlett, count - 1.0);
}

bool are_in_line(const std::unordered_set<std::size_t>& pixels, std::size_t width) {
    std::map<std::size_t, std::vector<std::size_t>> rows, columns;
    for (const std::size_t i : std::set(pixels.begin(), pixels.end())) {
        rows[i / width].push_back(i % width);
        columns[i % width].push_back(i / width);
    }
    const auto fails = [](const auto& line) {
        return are_in_rhythm(line.second)
               || (line.second.size() > max_in_rhythm
                   && chance_of_evenness(line.second) < max_chance_of_evenness);
    };
    return std::ranges::any_of(rows, fails) || std::ranges::any_of(columns, fails);
}

bool are_in_rectangle(const std::unordered_set<std::size_t>& pixels, std::size_t width) {
    constexpr std::size_t min_edge = 3; // [pixels]
    std::map<std::size_t, std::vector<std::size_t>> rows;
    for (const std::size_t i : pixels) rows[i / width].push_back(i % width);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> row_of; // the first that has both columns
    std::set<std::size_t> corners;
    for (auto& [row, columns] : rows) {
        std::ranges::sort(columns);
        for (std::size_t a = 0; a < columns.size(); ++a)
            for (std::size_t b = a + 1; b < columns.size(); ++b) {
                if (columns[b] - columns[a] < min_edge) continue;
                const auto [place, is_new] = row_of.try_emplace({columns[a], columns[b]}, row);
                if (is_new || row - place->second < min_edge) continue;
                for (const std::size_t y : {row, place->second})
                    corners.insert({y * width + columns[a], y * width + columns[b]});
            }
    }
    return 2 * corners.size() > pixels.size();
}

} // namespace sr::compare
