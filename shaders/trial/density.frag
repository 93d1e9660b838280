#version 410 core
// A direction of the row's number, in the subject's frame, and p / q there: in the mean, what of p lies above the horizon.
#include "surface/surface.glsl"
#include "brdf/f_r.glsl"
#include "brdf/sample_f_r.glsl"
#include "trial/density.glsl"
#include "trial/directions.glsl"
#include "trial/subject.glsl"
#include "trial/table.glsl"

void main() {
    answer = vec4(0.0, 0.0, -1.0, 0.0);
    if (row_number() >= row_count) return;
    Surface x = subject();
    vec3 wo = subject_frame() * row_part(0).xyz;
    vec3 wi = direction_of(int(row_part(0).w), x, wo);
    if (dot(subject_n, wi) <= 0.0) return;
    answer = vec4(wi * subject_frame(), density(x, wi, wo) / density_of_directions(x, wi, wo));
}
