// One lobe of f_r over one emitter: in closed form where there is one and by few points elsewhere.
//
//   ∫ f L_e cosθ dω  ≈  E/π Σ w_i r_i / Σ w_i,      r = f L_e cosθ / p
//
// f: a lobe of f_r. p: the density that M makes of the cosine, near the lobe (brdf/warp.glsl). E/π: the emitter's part
// of it, exact with outline and horizon (light/visible_outline.glsl). The points lie evenly in p. For Lambert's lobe r
// is constant and the result exact; elsewhere it converges with the points. Without points: Heitz et al. 2016. The
// ratio: Heitz, Hill & McGuire 2018. Points where p is: Peters 2021, who draws them; these are a fixed fan.
#include "brdf/lobes.glsl"
#include "brdf/warp.glsl"
#include "integrator/cosine.glsl"
#include "interface/estimator.glsl"
#include "light/outlined.glsl"

// One lobe of the BRDF and its warp.
struct WarpedLobe {
    bool is_specular;
    Warp warp;
};

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

// A direction chosen among all points of a light, each in proportion to what it adds, and moved at random within the
// part of the emitter that it stands for: where to look for shadows. Chosen as the points come (Chao 1982).
struct Chosen {
    vec3 wi;
    int part;
    float total; // of what the points so far add
    vec3 u;      // random: the choice, and the place within a step
};

void choose(inout Chosen chosen, vec3 wi, int part, float amount) {
    chosen.total += amount;
    float share = amount / chosen.total;
    bool is_chosen = chosen.u.x < share;
    chosen.wi = is_chosen ? wi : chosen.wi;
    chosen.part = is_chosen ? part : chosen.part;
    chosen.u.x = is_chosen ? chosen.u.x / share : (chosen.u.x - share) / (1.0 - share);
}

float brightness(vec3 color) { return color.r + color.g + color.b; }

vec3 reflected_by_lobe(WarpedLobe lobe, Light light, int part, int points, Surface x, vec3 wo, inout Chosen chosen) {
    Outline outline = outline_of(light, part, x.position, lobe.warp.warped_from_world);
    VisibleOutline v = visible_part(outline);
    if (v.E <= 0.0) return vec3(0.0);
    vec3 mean = analytic_points == 0 ? mean_ratio(v.center, lobe, light, part, x, wo) : vec3(0.0);
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int k = 0; k <= outline.count; ++k) { // the last is the horizon
        Arc arc = v.closing;
        if (k < outline.count) arc = piece_at(outline, k).arc;
        int steps = steps_of(arc, v, points / points_a_step);
        for (int i = 0; i < steps; ++i) {
            FanStep fan = fan_step(arc, float(i) + 0.5, steps, v.center);
            FanStep moved = fan_step(arc, float(i) + chosen.u.y, steps, v.center);
            for (int j = 0; j < points_a_step; ++j) {
                vec3 q = fan_point(fan, fan_distance(j), v.center);
                float weight = fan.weight * q.z;
                vec3 r = analytic_points == 0 ? mean : ratio_at(q, lobe, light, part, x, wo);
                sum += weight * r;
                weights += weight;
                vec3 q_moved = fan_point(moved, (float(j) + chosen.u.z) / float(points_a_step), v.center);
                vec3 wi = lobe.warp.world_from_warped * q_moved;
                float amount = weight * brightness(r);
                if (amount > 0.0) choose(chosen, wi, part, amount);
            }
        }
    }
    return weights > 0.0 ? v.E / pi * sum / weights : vec3(0.0);
}

// Both lobes over outline `part` of `parts` of the light, by about analytic_points / parts points each.
vec3 reflected_from_outline(Light light, int part, int parts, Surface x, vec3 wo, inout Chosen chosen) {
    vec3 L_r = vec3(0.0);
    int points = analytic_points == 0 ? 8 : analytic_points; // without points these are for shadows alone
    for (int i = 0; i < 2; ++i) { // one loop, since every call is another copy of all that it takes
        bool is_specular = i == 1;
        if (is_specular ? !has_specular_lobe(x) : !has_diffuse_lobe(x)) continue;
        WarpedLobe lobe = WarpedLobe(is_specular, diffuse_warp(x, wo));
        if (is_specular) lobe.warp = specular_warp(x, wo);
        L_r += reflected_by_lobe(lobe, light, part, points / parts, x, wo, chosen);
    }
    return L_r;
}
