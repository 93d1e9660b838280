#version 410 core
// f_r(wi, wo) [1/sr], directions in the tilted frame.
#include "surface/surface.glsl"
#include "brdf/f_r.glsl"
#include "brdf_eval/surface_from_parameters.glsl"
#include "brdf_eval/table.glsl"

void main() {
    answer = vec4(0.0);
    if (row_number() >= row_count) return;
    vec3 wi = tilted_frame() * row_part(0).xyz;
    vec3 wo = tilted_frame() * row_part(1).xyz;
    answer = vec4(f_r(surface_from_parameters(wo), wi, wo), 1.0);
}
