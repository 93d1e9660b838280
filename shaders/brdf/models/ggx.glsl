// GGX microfacets whose reflectance at normal incidence is the base colour.
#include "brdf/fresnel.glsl"
#include "brdf/models/microfacet_model.glsl"

float roughness_across() { return model_parameters[0].x; }

vec3 F_metal_of(Surface x, float cos_h) { return F_schlick(x.base_color, cos_h); }
vec3 F_mean_of(Surface x) { return mean_schlick(x.base_color); }
