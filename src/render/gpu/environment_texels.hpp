#pragma once
// The maps of environments, as texels that a shader can read in any direction and sample.
#include "scene/lights/light.hpp"

#include <vector>

namespace sr::render {

/// Every map once, for as long as it lives: the same scene in other light has the same maps. A map begins
/// with a texel a row: what its density is besides the texel's own share [1/sr], where it begins and ends
/// (EnvironmentMap::pole_heights), and the rows' cdf. Behind them its texels, each with the cdf of its row.
/// Keep in sync with shaders/light/environment.glsl.
class EnvironmentTexels {
public:
    /// The first texel of a map with light. @throws Error if maps are too large for 32-bit floats to name it
    std::size_t place_of(const std::shared_ptr<const scene::EnvironmentMap>& map);

    const std::vector<vec4>& texels() const { return texels_; }

private:
    struct Place {
        std::shared_ptr<const scene::EnvironmentMap> map;
        std::size_t first = 0;
    };

    std::vector<Place> places_;
    std::vector<vec4> texels_;
};

} // namespace sr::render
