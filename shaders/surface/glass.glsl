// Straight-through transmittance of a glass surface under the angle θ.
//
//   T = (1 - metallic) t ρ (1 - s max F(cosθ)) (1 - c F_coat(cosθ)) exp(-σ d)
//
// t: KHR_materials_transmission; ρ: the base colour; s, F: KHR_materials_specular and _ior (Schlick 1994, Eq. 15); c:
// KHR_materials_clearcoat; σ = -ln(attenuationColor) / attenuationDistance and d, the thickness in world space:
// KHR_materials_volume (Beer 1852). Each surface that is crossed is one interface, as glTF's thin walls are, so a closed
// bottle of two walls has two. A closed mesh attenuates where it is entered, since d is the way to its other side; an
// open one is a sheet and attenuates from either side. Limits: no refraction, so d is the same under every angle, and no
// blur by roughness.
// Keep in sync with src/shadow/transparency.cpp.
#include "brdf/fresnel.glsl"

struct Glass {
    vec3 color;         // (1 - metallic) t ρ
    float F0;           // the largest of its channels
    float specular;     // s
    float clearcoat;    // c
    vec3 optical_depth; // σ d
};

vec3 straight_transmittance(Glass glass, float cos_w) {
    float weight = schlick_weight(cos_w);
    float F = glass.specular * mix(glass.F0, 1.0, weight);
    float F_coat = glass.clearcoat * mix(0.04, 1.0, weight);
    return glass.color * ((1.0 - F) * (1.0 - F_coat)) * exp(-glass.optical_depth);
}
