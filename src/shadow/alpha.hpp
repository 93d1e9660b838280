#pragma once
// Alpha of surfaces that are not opaque: base colour factor × texture × vertex colour, as shadows see it,
// that is, bilinear in the full-size texture. Keep in sync with shaders/visibility/alpha.glsl.
#include "scene/scene.hpp"

namespace sr::shadow {

/// Where the alphas of a texture, or another of its channels, lie among those of all.
struct AlphaMap {
    int first = 0;
    int width = 0;
    int height = 0;
    scene::Wrap wrap_u = scene::Wrap::repeat;
    scene::Wrap wrap_v = scene::Wrap::repeat;
};

/// One corner of a triangle that is not opaque.
struct AlphaCorner {
    vec2 uv{0.0f};      // where the map is read, the texture's transform applied
    float alpha = 1.0f; // base colour factor × vertex colour
};

/// Alpha at `uv` of the map whose texels these are, in [0, 1].
float map_alpha(const AlphaMap& map, const std::vector<std::uint16_t>& texels, vec2 uv);

/// A channel (0 to 3) of an image; 8 bits are widened exactly. `is_srgb`: decoded to linear light.
std::vector<std::uint16_t> channel_of(const scene::TextureImage& image, std::size_t channel,
                                      bool is_srgb = false);

} // namespace sr::shadow
