// Stochastic transparency: a depth map has one surface a texel. A transparent one is there in as many frames as its alpha says, each triangle by
// itself, so that in the mean over frames all layers multiply (Enderton et al. 2010, "Stochastic transparency", section 4).
#include "base/sampling.glsl"
#include "interface/frame.glsl"

// Returns whether the depth map that `map_seed` names has this triangle, where its alpha is `alpha`.
bool is_kept(int triangle, uint map_seed, float alpha) {
    return sobol_2d(sample_index, hash(uint(triangle), map_seed)).x < alpha;
}
