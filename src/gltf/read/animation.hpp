#pragma once
// glTF animations: values over time (glTF 2.0 specification, section 3.11 and appendix C), and the properties
// that they set.
#include "gltf/read/animated_property.hpp"
#include "gltf/warnings.hpp"

#include <cstddef>
#include <string>
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

struct Channel {
    Track track;
    AnimatedProperty property;
};

struct Animation {
    std::string name;
    double duration = 0.0; // time of the last key [s]
    bool is_whole = true;  // false: channels are lost, which may have had later keys
    std::vector<Channel> channels;

    /// Sets the properties to their values at a time [s].
    void apply(double seconds);
    /// Sets them back to what the file says.
    void reset();
};

/// Channels that are broken (a sampler that is not there; keys that are not in order, not finite, or not as
/// many as values), move nothing, or move what is not supported, are left out, with a warning each.
std::vector<Animation> parse_animations(Document& document, Warnings& warnings);

} // namespace sr::gltf
