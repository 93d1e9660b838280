// Share of the light towards wo that the clear coat reflects rather than transmits: KHR_materials_clearcoat, "Layering".
//
//   c (F0 + (1 - F0) (1 - n_c·wo)⁵)
#include "brdf/fresnel.glsl"
#include "surface/surface.glsl"

const float F0_coat = 0.04; // an index of refraction of 1.5

float coat_weight(Surface x, vec3 wo) {
    return x.clearcoat * F_schlick(vec3(F0_coat), max(dot(x.clearcoat_n, wo), 0.0)).x;
}
