// Directions over the hemisphere in which any BRDF's lobes are found: even numbers as the cosine, odd ones as a GGX lobe of one of four
// widths, two of them the material's own, all under the density of the whole mixture (Veach & Guibas 1995, balance heuristic).
#include "base/sampling.glsl"
#include "brdf/brdf.glsl"
#include "brdf/cosine_sampling.glsl"
#include "brdf/ggx_sampling.glsl"
#include "interface/features.glsl"
#include "surface/surface.glsl"

float[4] widths_for(Surface x) {
    return float[4](peak_alpha(x), has_clearcoat ? x.clearcoat_alpha : alpha_of(0.15), 0.12, 0.5);
}

vec3 direction_of(int number, Surface x, vec3 wo) {
    float[4] widths = widths_for(x);
    vec2 u = sobol_2d(uint(number) / 8u, 11u + uint(number) % 8u);
    return number % 2 == 0 ? sample_cosine(x.n, u) : sample_ggx(x.n, wo, widths[(number / 2) % 4], u);
}

float density_of_directions(Surface x, vec3 wi, vec3 wo) {
    float[4] widths = widths_for(x);
    float q = 0.5 * p_cosine(x.n, wi);
    for (int i = 0; i < 4; ++i) q += 0.125 * p_ggx(x.n, wi, wo, widths[i]);
    return q;
}
