#version 410 core
// The direction that sampling makes of u, in the tilted frame, and its density.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "brdf_eval/surface_from_parameters.glsl"
#include "brdf_eval/table.glsl"

void main() {
    answer = vec4(0.0);
    if (row_number() >= row_count) return;
    vec3 wo = tilted_frame() * row_part(0).xyz;
    Surface x = surface_from_parameters(wo);
    vec3 wi = sample_f_r(x, wo, row_part(1).xy);
    answer = vec4(wi * tilted_frame(), pdf_f_r(x, wi, wo));
}
