#version 410 core
// Masks converged pixels: writes black in front of everything, so that nothing is drawn or added there.
uniform sampler2D frozen; // not 0 where a pixel takes no more samples

out vec4 frame;

void main() {
    if (texelFetch(frozen, ivec2(gl_FragCoord.xy), 0).r == 0.0) discard;
    frame = vec4(0.0);
    gl_FragDepth = 0.0;
}
