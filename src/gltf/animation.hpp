#pragma once
// glTF animations: tracks, and the properties that they move.
#include "gltf/property.hpp"
#include "gltf/track.hpp"
#include "gltf/warnings.hpp"

#include <string>
#include <vector>

namespace sr::gltf {

struct Channel {
    Track track;
    Property property;
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
std::vector<Animation> animations_of(Document& document, Warnings& warnings);

} // namespace sr::gltf
