// Oren-Nayar of the material's roughness. The analytic estimator takes it as it does a GGX lobe, near Lambert's.
#include "brdf/models/diffuse_model.glsl"
#include "brdf/oren_nayar.glsl"

vec3 f_r(Surface x, vec3 wi, vec3 wo) {
    if (dot(x.n, wi) <= 0.0) return vec3(0.0);
    return f_oren_nayar(x.base_color, x.roughness, x.n, wi, wo);
}
