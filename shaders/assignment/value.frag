#version 410 core
// One expression over a table of inputs, which assignment/asked.glsl declares and evaluates.
#include "assignment/not_implemented.glsl"
#include "brdf_eval/table.glsl"
#include "assignment/asked.glsl"

void main() {
    answer = vec4(0.0);
    if (row_number() >= row_count) return;
    answer = asked();
    // 2^127 in every component: what src/assignment/evaluation.hpp takes for "not implemented".
    if (not_implemented_calls > 0) answer = vec4(uintBitsToFloat(0x7f000000u));
}
