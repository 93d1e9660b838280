#version 410 core
// f_r(wi, wo) [1/sr], directions in the subject's frame.
#include "surface/surface.glsl"
#include "brdf/f_r.glsl"
#include "trial/subject.glsl"
#include "trial/table.glsl"

void main() {
    answer = vec4(0.0);
    if (row_number() >= row_count) return;
    mat3 frame = subject_frame();
    answer = vec4(f_r(subject(), frame * row_part(0).xyz, frame * row_part(1).xyz), 1.0);
}
