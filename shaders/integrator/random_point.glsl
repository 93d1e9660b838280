// The random numbers of a sample. All pixels have one point of a sequence of six dimensions (src/render/sampling.hpp): the
// first two are the place in the pixel, sample_digits are the others. Each pixel and purpose scrambles them by itself, so
// that none is correlated with another, while points on a light stay spread over the places in the pixel.
#include "base/sampling.glsl"
#include "interface/frame.glsl"

uint seed_of(uint purpose) {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    return hash(pixel.x, hash(pixel.y, hash(purpose, seed)));
}

// Purpose 0 is the BRDF's direction, k + 1 the point on light k.
vec2 random_point(uint purpose) { return scrambled_point(sample_digits.xy, seed_of(purpose)); }

// For numbers that one estimate uses together with those of random_point().
vec2 further_random_point(uint purpose) { return scrambled_point(sample_digits.zw, seed_of(purpose)); }
