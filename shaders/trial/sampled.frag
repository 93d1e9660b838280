#version 410 core
// The direction that sampling makes of u, in the subject's frame, and its density.
#include "surface/surface.glsl"
#include "brdf/f_r.glsl"
#include "brdf/sample_f_r.glsl"
#include "trial/density.glsl"
#include "trial/subject.glsl"
#include "trial/table.glsl"

void main() {
    answer = vec4(0.0);
    if (row_number() >= row_count) return;
    vec3 wo = subject_frame() * row_part(0).xyz;
    vec3 wi = sample_f_r(subject(), wo, row_part(1).xy);
    answer = vec4(wi * subject_frame(), density(subject(), wi, wo));
}
