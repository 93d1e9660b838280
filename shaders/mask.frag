#version 410 core
// Masks converged pixels: nothing is drawn or added there, since the depth is that of the near plane.
uniform sampler2D frozen; // not 0 where a pixel takes no more samples

void main() {
    if (texelFetch(frozen, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
}
