// The random numbers of a sample.
#include "base/sampling.glsl"
#include "interface/frame.glsl"

// A sequence of its own for every pixel and purpose, so that none is correlated with another. Purpose 0 is the BRDF's
// direction, k + 1 the point on light k.
vec2 random_point(uint purpose) {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    return sobol_2d(sample_index, hash(pixel.x, hash(pixel.y, hash(purpose, seed))));
}
