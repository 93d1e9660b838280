// f_r in two summands, for estimators that integrate each in a way of its own: what scatters everywhere, and the GGX
// lobe. Overlay it together with f_r.glsl.
#include "brdf/metallic_roughness.glsl"

Lobes lobes(Surface x, vec3 wi, vec3 wo) { return metallic_roughness_lobes(x, wi, wo); }

bool has_diffuse_lobe(Surface x) { return x.metallic < 1.0 && x.base_color != vec3(0.0); }
bool has_specular_lobe(Surface x) { return x.metallic > 0.0 || x.specular > 0.0; }

// The specular lobe's part of the albedo, from ∫ D V cosθ and ∫ (1 - w·h)⁵ D V cosθ.
vec3 specular_albedo(Surface x, float DV, float schlick) {
    vec3 F0 = mix(x.specular * x.F0_dielectric, x.base_color, x.metallic);
    float F90 = mix(x.specular, 1.0, x.metallic);
    return F0 * (DV - schlick) + F90 * schlick;
}
