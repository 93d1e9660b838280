#version 410 core
// forward.frag for shadow rays that the CPU traces: L_e at once, and of L_r the samples (visibility/deferred.glsl).
#include "interface/deferred.glsl"
#include "integrator/bounded.glsl"
#include "integrator/outgoing.glsl"
#include "surface/at_fragment.glsl"

layout(early_fragment_tests) in; // hidden fragments must not write

out vec4 film; // L_e [cd/m²] and coverage, which is 1

void write_receiver(Surface x, int pixel) {
    int first = deferred_pairs_of(pixel);
    deferred[first] = pair(x.position.x, x.position.y);
    deferred[first + 1] = pair(x.position.z, intBitsToFloat(x.triangle));
}

void main() {
    deferred_count = 0;
    Surface x = surface_at_fragment();
    film = vec4(bounded(outgoing(x, direction_to_viewer())), 1.0);
    int pixel = pixel_of_rows();
    if (deferred_count > 0) write_receiver(x, pixel);
    deferred[pixel] = pair(intBitsToFloat(deferred_count), 0.0);
}
