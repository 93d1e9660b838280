#pragma once
// Values over time, as a sampler of a glTF animation has them (glTF 2.0 specification, section 3.11 and
// appendix C).
#include <cstddef>
#include <vector>

namespace sr::gltf {

enum class Interpolation { step, linear, cubic_spline };

struct Track {
    std::vector<float> times; // of the keys [s]; they do not decrease, and there is one at least
    /// `width` numbers a key; for cubic_spline three times as many: in-tangent, value, out-tangent [1/s].
    std::vector<float> values;
    std::size_t width = 1;
    Interpolation interpolation = Interpolation::linear;
    /// The values are quaternions x y z w: linear is along the shorter great arc, and the result has
    /// length 1.
    bool is_rotation = false;

    /// The numbers at a time [s]: before the first key and after the last those of that key.
    std::vector<double> at(double seconds) const;
};

} // namespace sr::gltf
