#version 410 core
// Writes the shadow rays of the shading pass to targets, for the CPU to trace. It is the shading pass itself with
// visibility/record.glsl in place of an answer, so samples are defined once; the compiler drops what no ray needs.
#include "integrator/reflected.glsl"
#include "surface/at_fragment.glsl"
#include "visibility/recorded.glsl"

layout(location = 0) out vec4 receiver;          // x [m], and the triangle that it lies on
layout(location = 1) out vec4 rays[rays_a_pass]; // see visibility/recorded.glsl

uniform sampler2D last_rays; // what the pass before left in its last place

// A pixel that left its last place empty has no further ray.
bool is_complete() { return first_ray > 0 && texelFetch(last_rays, ivec2(gl_FragCoord.xy), 0).w == 0.0; }

void main() {
    for (int i = 0; i < rays_a_pass; ++i) recorded[i] = vec4(0.0);
    recorded_count = 0;
    Surface x = surface_at_fragment();
    if (!is_unlit && !is_complete()) reflected(x, direction_to_viewer());
    receiver = vec4(x.position, float(x.triangle));
    for (int i = 0; i < rays_a_pass; ++i) rays[i] = recorded[i];
}
