// Light that a thin sheet scatters to its other side, as leaves and paper do: Lambert's lobe around -n.
//
//   f = (1 - metallic) (1 - t) (1 - s max F(w'·h')) δ C / π          [1/sr],  n·wi < 0 < n·wo
//
// KHR_materials_diffuse_transmission: δ, its share of the diffuse base, and C, its colour. t: KHR_materials_transmission,
// which goes before it. w': wi mirrored to the side of wo, h' between them, so that f is reciprocal. What is reflected
// keeps the share 1 - δ (metallic_roughness.glsl). Limit: with KHR_materials_volume nothing is scattered within.
#include "brdf/lambert.glsl"
#include "interface/features.glsl"
#include "surface/surface.glsl"

// Share of the diffuse base's light that is reflected, not transmitted.
float reflected_share(Surface x) {
    float share = 1.0;
    if (has_diffuse_transmission) share *= 1.0 - x.diffuse_transmission;
    if (is_transmissive) share *= 1.0 - x.transmission;
    return share;
}

// Without (1 - s max F).
vec3 f_transmitted(Surface x) {
    float share = (1.0 - x.metallic) * x.diffuse_transmission;
    if (is_transmissive) share *= 1.0 - x.transmission;
    return share * f_lambert(x.diffuse_transmission_color);
}
