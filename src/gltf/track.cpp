#include "gltf/track.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

namespace sr::gltf {
namespace {

glm::dquat quaternion(const double* xyzw) { return {xyzw[3], xyzw[0], xyzw[1], xyzw[2]}; }

void slerp(const double* from, const double* to, double t, double* result) {
    const glm::dquat between = glm::slerp(quaternion(from), quaternion(to), t);
    result[0] = between.x, result[1] = between.y, result[2] = between.z, result[3] = between.w;
}

} // namespace

std::vector<double> Track::at(double seconds) const {
    const bool is_cubic = interpolation == Interpolation::cubic_spline;
    // part 0: in-tangent, 1: value, 2: out-tangent
    const auto number = [&](std::size_t key, std::size_t part, std::size_t i) {
        return double{values[(is_cubic ? 3 * key + part : key) * width + i]};
    };
    const auto value = [&](std::size_t key) {
        std::vector<double> numbers(width);
        for (std::size_t i = 0; i < width; ++i) numbers[i] = number(key, 1, i);
        return numbers;
    };
    const auto after = std::upper_bound(times.begin(), times.end(), seconds,
                                        [](double a, float b) { return a < double{b}; });
    const auto next = static_cast<std::size_t>(after - times.begin());
    if (next == 0) return value(0);
    const std::size_t key = next - 1;
    if (next == times.size() || interpolation == Interpolation::step) return value(key);

    const double duration = double{times[next]} - times[key];
    const double t = (seconds - times[key]) / duration;
    std::vector<double> result = value(key);
    if (interpolation == Interpolation::linear) {
        const std::vector<double> end = value(next);
        if (is_rotation)
            slerp(value(key).data(), end.data(), t, result.data());
        else
            for (std::size_t i = 0; i < width; ++i) result[i] = (1.0 - t) * result[i] + t * end[i];
        return result;
    }
    const double t2 = t * t, t3 = t2 * t; // appendix C.5: Hermite's basis
    for (std::size_t i = 0; i < width; ++i)
        result[i] = (2.0 * t3 - 3.0 * t2 + 1.0) * number(key, 1, i)
                    + duration * (t3 - 2.0 * t2 + t) * number(key, 2, i)
                    + (3.0 * t2 - 2.0 * t3) * number(next, 1, i) + duration * (t3 - t2) * number(next, 0, i);
    const double length = is_rotation ? glm::length(quaternion(result.data())) : 1.0;
    if (length > 0.0)
        for (double& n : result) n /= length;
    return result;
}

} // namespace sr::gltf
