#pragma once
// The textures of emitters, as linear texels that a shader can read at any point of any light.
#include "scene/scene.hpp"

#include <array>
#include <map>

namespace sr::render {

/// Where a texture lies among the texels of all: the first one, its size, and its wrap modes as
/// wrap_u + 4 * wrap_v in the order of scene::Wrap. Keep in sync with
/// shaders/light/emission_map.glsl.
struct EmissionMapPlace {
    int first = 0;
    int width = 0;
    int height = 0;
    int wrap = 0;
};

/// Appends every texture once, for as long as it lives: a scene at another moment, or in other light, has the
/// same textures. Texels are linear RGBA in half precision, whose steps (2^-11) are finer than those of 8-bit
/// sRGB.
class EmissionMaps {
public:
    EmissionMapPlace place_of(const scene::Scene& scene, int texture);

    /// The mean linear colour of the part of a texture that a triangle covers, by 64 points of it.
    /// Remembered, for those who ask about the same triangles in the same order after each ask_anew().
    vec3 mean(const scene::Scene& scene, int texture, const std::array<vec2, 3>& uv);

    void ask_anew() { asked_ = 0; }

    /// Four half floats a texel.
    const std::vector<std::uint64_t>& texels() const { return texels_; }

private:
    struct Mean {
        int texture = -1;
        std::array<vec2, 3> uv{};
        vec3 color{0.0f};
    };

    vec3 measured_mean(const scene::Scene& scene, int texture, const std::array<vec2, 3>& uv);

    std::map<int, EmissionMapPlace> places_;
    std::vector<std::uint64_t> texels_;
    std::vector<Mean> means_;
    std::size_t asked_ = 0; // of means_
};

} // namespace sr::render
