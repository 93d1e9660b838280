#pragma once
// Surfaces that shadows see through: alpha, and glass (KHR_materials_transmission). Textures are read
// bilinear, in full size.
#include "scene/scene.hpp"

#include <array>
#include <span>

namespace sr::shadow {

// Alpha: base colour factor × texture × vertex colour. Keep in sync with shaders/visibility/alpha.glsl.

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

// Glass. Keep in sync with shaders/surface/glass.glsl, which has the equation, and
// shaders/visibility/glass.glsl.

/// Data shared by the triangles of one glass instance. Maps: indices into Casters::alpha_maps;
/// negative: none.
struct Glass {
    float transmission = 1.0f;
    float metallic = 0.0f;
    float F0 = 0.04f; // the largest of its channels
    float specular = 1.0f;
    float clearcoat = 0.0f;
    vec3 optical_depth{0.0f}; // where the thickness map is 1
    float front = 1.0f;       // -1 where triangles are clockwise seen from the front
    bool is_body = false;     // a closed mesh, which attenuates only where it is entered
    int base_map = -1;        // four planes: red, green, blue (linear), alpha
    int transmission_map = -1;
    int thickness_map = -1;
    int metallic_map = -1;
};

/// One corner of a triangle of glass.
struct GlassCorner {
    std::array<vec2, 4> uv{}; // of the base colour, transmission, thickness and metallic maps
    vec4 color{1.0f};         // base colour factor × vertex colour
};

/// Properties of a glass triangle at the point where a ray hits it.
struct GlassPoint {
    vec3 color{1.0f}; // (1 - metallic) t ρ
    float alpha = 1.0f;
    float thickness = 1.0f; // of the map
};

/// At the weights of the three corners. `maps` and `texels`: those of the casters.
GlassPoint glass_at(const Glass& glass, std::span<const GlassCorner, 3> corners, vec3 weights,
                    const std::vector<AlphaMap>& maps, const std::vector<std::uint16_t>& texels);

/// T of shaders/surface/glass.glsl for a ray of direction w through a triangle of normal n, of any lengths.
vec3 straight_transmittance(const Glass& glass, const GlassPoint& point, vec3 n, vec3 w);

} // namespace sr::shadow
