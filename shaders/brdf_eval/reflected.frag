#version 410 core
// f_r cosθ_i / q in a direction of the row's number: in the mean over numbers, the albedo for wo.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "brdf_eval/directions.glsl"
#include "brdf_eval/surface_from_parameters.glsl"
#include "brdf_eval/table.glsl"

void main() {
    answer = vec4(0.0);
    if (row_number() >= row_count) return;
    vec3 wo = tilted_frame() * row_part(0).xyz;
    Surface x = surface_from_parameters(wo);
    vec3 wi = direction_of(int(row_part(0).w), x, wo);
    float cos_i = dot(x.n, wi);
    if (cos_i <= 0.0) return;
    answer = vec4(f_r(x, wi, wo) * cos_i / density_of_directions(x, wi, wo), 1.0);
}
