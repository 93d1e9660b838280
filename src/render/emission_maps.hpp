#pragma once
// The textures of emitters, as linear texels that a shader can read at any point of any light.
#include "scene/scene.hpp"

#include <array>
#include <map>

namespace sr::render {

/// Where a texture lies among the texels of all: the first one, its size, and its wrap modes as
/// wrap_u + 4 * wrap_v in the order of scene::Wrap. Mirror: shaders/light/emission_map.glsl.
struct EmissionMapPlace {
    int first = 0;
    int width = 0;
    int height = 0;
    int wrap = 0;
};

/// Appends every texture once. Texels are linear RGBA in half precision, whose steps (2^-11) are finer than
/// those of 8-bit sRGB.
class EmissionMaps {
public:
    explicit EmissionMaps(const scene::Scene& scene) : scene_(scene) {}

    EmissionMapPlace place_of(int texture);

    /// The mean linear colour of the part of a texture that a triangle covers, by 64 points of it.
    vec3 mean(int texture, const std::array<vec2, 3>& uv);

    /// Four half floats a texel.
    const std::vector<std::uint64_t>& texels() const { return texels_; }

private:
    const scene::Scene& scene_;
    std::map<int, EmissionMapPlace> places_;
    std::vector<std::uint64_t> texels_;
};

} // namespace sr::render
