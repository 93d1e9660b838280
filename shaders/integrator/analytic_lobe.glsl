// One lobe of f_r over one emitter: in closed form where there is one and by few points elsewhere.
//
//   ∫ f L_e cosθ dω  ≈  E/π Σ w_i r_i / Σ w_i,      r = f L_e cosθ / p
//
// f: a lobe of f_r. p: the density that M makes of the cosine, near the lobe (brdf/warp.glsl). E/π: the emitter's part
// of it, exact with outline and horizon (light/visible_outline.glsl). The points lie evenly in p. For Lambert's lobe r
// is constant and the result exact; elsewhere it converges with the points. Without points: Heitz et al. 2016. The
// ratio: Heitz, Hill & McGuire 2018. Points where p is: Peters 2021, who draws them; these are a fixed fan.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "brdf/warp.glsl"
#include "integrator/cosine.glsl"
#include "interface/estimator.glsl"
#include "light/quadrature.glsl"
#include "light/outlined.glsl"

// One lobe of the BRDF and its warp.
struct WarpedLobe {
    bool is_specular;
    Warp warp;
};

bool has_lobe(Surface x, bool is_specular) { return is_specular ? has_specular_lobe(x) : has_diffuse_lobe(x); }

WarpedLobe warped_lobe(Surface x, vec3 wo, bool is_specular) {
    WarpedLobe lobe = WarpedLobe(is_specular, diffuse_warp(x, wo));
    if (is_specular) lobe.warp = specular_warp(x, wo);
    return lobe;
}

vec3 lobe_of(bool is_specular, Surface x, vec3 wi, vec3 wo) {
    Lobes f = lobes(x, wi, wo);
    return is_specular ? f.specular : f.diffuse;
}

// r at the warped unit direction q. The lobe's density is cos(q)/π |M q|³ / det M, and cosθ = cos(q) / |M q|.
vec3 ratio_at(vec3 q, WarpedLobe lobe, Light light, int part, Surface x, vec3 wo) {
    vec3 w = lobe.warp.world_from_warped * q;
    float l = length(w);
    vec3 wi = w / l;
    if (cosine(x, wi) <= 0.0) return vec3(0.0);
    float l2 = l * l;
    return lobe_of(lobe.is_specular, x, wi, wo) * radiance_towards(light, part, x.position, wi)
           * (pi * lobe.warp.determinant / (l2 * l2));
}

// r where there are no points: for the GGX lobe the albedo.
vec3 mean_ratio(vec3 center, WarpedLobe lobe, Light light, int part, Surface x, vec3 wo) {
    if (!lobe.is_specular) return ratio_at(center, lobe, light, part, x, wo);
    vec2 terms = specular_terms(x, wo);
    vec3 wi = normalize(lobe.warp.world_from_warped * center);
    return specular_albedo(x, terms.x, terms.y) * radiance_towards(light, part, x.position, wi);
}

float brightness(vec3 color) { return color.r + color.g + color.b; }

// Sums over the points of one outline for one lobe.
struct Sum {
    vec3 ratio;    // Σ w r / Σ w
    float E;       // of the outline [sr]
    float amount;  // Σ w brightness(r)
};

int points_of_a_lobe(int parts) { return (analytic_points == 0 ? 8 : analytic_points) / parts; }

Sum sum_over_outline(WarpedLobe lobe, Light light, int part, int parts, Surface x, vec3 wo) {
    Outline outline = outline_of(light, part, x.position, lobe.warp.warped_from_world);
    VisibleOutline v = visible_part(outline);
    if (!(v.E > 0.0)) return Sum(vec3(0.0), 0.0, 0.0);
    vec3 mean = analytic_points == 0 ? mean_ratio(v.center, lobe, light, part, x, wo) : vec3(0.0);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int k = 0; k <= outline.count; ++k) { // the last is the horizon
        Arc arc = arc_of(outline, v, k);
        int steps = steps_of(arc, v, points_of_a_lobe(parts) / points_a_step);
        for (int i = 0; i < steps; ++i) {
            QuadratureStep slice = quadrature_step(arc, float(i) + 0.5, steps, v.center);
            for (int j = 0; j < points_a_step; ++j) {
                vec3 q = quadrature_point(slice, quadrature_distance(j), v.center);
                float weight = slice.weight * q.z;
                sum += weight * (analytic_points == 0 ? mean : ratio_at(q, lobe, light, part, x, wo));
                weights += weight;
            }
        }
    }
    return Sum(weights > 0.0 ? sum / weights : vec3(0.0), v.E, brightness(sum));
}

// Both lobes over outline `part` of `parts` of the light. a: what its points add, see Sum.
vec4 reflected_from_outline(Light light, int part, int parts, Surface x, vec3 wo) {
    vec4 L_r = vec4(0.0);
    for (int i = 0; i < 2; ++i) { // one loop, since every call is another copy of all that it takes
        if (!has_lobe(x, i == 1)) continue;
        Sum sum = sum_over_outline(warped_lobe(x, wo, i == 1), light, part, parts, x, wo);
        L_r += vec4(sum.E / pi * sum.ratio, sum.amount);
    }
    return L_r;
}
