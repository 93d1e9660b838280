// A6.5: stratification.
#include "sampling.glsl"
#include "assignment/not_implemented.glsl"

// The irradiance of the sky by one sample: f/p with the density of the cosine           [lx]
float E_of_sample(vec2 u) { return pi * L_sky(cosine_direction(vec3(0.0, 0.0, 1.0), u)); }

// begin solution A6.5
// u moved into cell i of side × side equal cells of [0, 1)²                              [1]
//
// Cell i is column i mod side (along x), row i / side (along y).
vec2 in_cell(int i, int side, vec2 u) { return (vec2(i % side, i / side) + u) / float(side); }

// The mean of E_of_sample over side² samples, one in each cell. Sample i takes random_2d(seed, i).      [lx]
float E_stratified(int side, float seed) {
    float sum = 0.0;
    for (int i = 0; i < side * side; ++i) sum += E_of_sample(in_cell(i, side, random_2d(seed, i)));
    return sum / float(side * side);
}
// end
