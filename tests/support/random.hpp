#pragma once
// Random numbers that are the same for a seed on every platform (the distributions of the standard are not).
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace sr::testing {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Uniform in [0, 1).
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double within(double low, double high) { return low + (high - low) * unit(); }
    /// Uniform in its logarithm.
    double scale_within(double low, double high) { return low * std::pow(high / low, unit()); }
    /// One of 0 … count - 1.
    int below(int count) { return static_cast<int>(unit() * count); }
    bool has_chance(double probability) { return unit() < probability; }

    glm::dvec3 in_cube(double half_edge) {
        const double x = within(-half_edge, half_edge), y = within(-half_edge, half_edge);
        return {x, y, within(-half_edge, half_edge)};
    }
    glm::dvec3 direction() {
        glm::dvec3 v = in_cube(1.0);
        while (!(glm::length(v) > 0.1 && glm::length(v) <= 1.0)) v = in_cube(1.0);
        return glm::normalize(v);
    }
    /// 0 … count - 1 in any order.
    std::vector<int> order(std::size_t count) {
        std::vector<int> order(count);
        std::iota(order.begin(), order.end(), 0);
        for (std::size_t i = count; i > 1; --i)
            std::swap(order[i - 1], order[static_cast<std::size_t>(below(static_cast<int>(i)))]);
        return order;
    }
    glm::dquat turn() { return glm::angleAxis(within(0.0, 6.28), direction()); }

private:
    std::mt19937_64 engine_;
};

} // namespace sr::testing
