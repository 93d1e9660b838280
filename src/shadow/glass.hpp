#pragma once
// Glass as shadows see it: KHR_materials_transmission with its textures, bilinear in the full-size image.
// Keep in sync with shaders/surface/glass.glsl, which has the equation, and shaders/visibility/glass.glsl.
#include "shadow/alpha.hpp"

#include <array>
#include <span>

namespace sr::shadow {

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
