#version 410 core
// Adds L_r, which the CPU summed over a pixel's samples, to the frame (the blend function does the adding).
#include "integrator/bounded.glsl"
#include "interface/rays.glsl"

uniform samplerBuffer ray_visibility; // L_r [cd/m²] of the pixels of a band

out vec4 film;

void main() {
    film = vec4(bounded(texelFetch(ray_visibility, pixel_of_rows()).rgb), 0.0);
}
