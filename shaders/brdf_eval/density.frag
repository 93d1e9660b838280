#version 410 core
// A direction of the row's number, in the tilted frame, and p / q there: in the mean, what of p lies above the horizon.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "brdf_eval/directions.glsl"
#include "brdf_eval/surface_from_parameters.glsl"
#include "brdf_eval/table.glsl"

void main() {
    answer = vec4(0.0, 0.0, -1.0, 0.0);
    if (row_number() >= row_count) return;
    vec3 wo = tilted_frame() * row_part(0).xyz;
    Surface x = surface_from_parameters(wo);
    vec3 wi = direction_of(int(row_part(0).w), x, wo);
    if (dot(x.n, wi) <= 0.0) return;
    answer = vec4(wi * tilted_frame(), pdf_f_r(x, wi, wo) / density_of_directions(x, wi, wo));
}
