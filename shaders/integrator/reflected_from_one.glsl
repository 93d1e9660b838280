// The reflection equation with chosen lights (--lights one puts this file in the place of reflected.glsl):
//
//   Σ_k ∫ f_r L_k V cosθ_i dω  =  E[ 1/c Σ w f_r L_k V cosθ_i / (P_k p) ]  +  E[ w' f_r L_m V cosθ_i / q ]
//
// c times the light tree chooses one light k, with the probability P_k, and the light a point of it, with the density
// p. The direction of the BRDF's choice, with the density q, meets light m. The weights are those of the power
// heuristic between c P_k p and q. Frames add up to the integral as in reflected.glsl, if P_k > 0 for every light that
// shines on x. The c choices take equal parts of [0, 1), so that they spread over the tree. Lights that are not at work
// (Frame) are chosen too, and add nothing.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "integrator/at_work.glsl"
#include "integrator/cosine.glsl"
#include "integrator/integrand.glsl"
#include "integrator/met_light.glsl"
#include "integrator/power_heuristic.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "interface/estimator.glsl"
#include "light/sample_light.glsl"
#include "light/tree.glsl"
#include "visibility/seen.glsl"

// Purposes of random_point(): 0 is the BRDF's direction, 1 the lights and the points on them.
const uint further_numbers = 2u;

const float max_gloss = 1e6; // metals have no diffuse part

// x as the light tree sees it: its peak is that of the GGX lobe.
LitPoint lit_point(Surface x, vec3 wo) {
    LitPoint lit = LitPoint(x.position, x.n, reflect(-wo, x.n), 0.0, 1.0);
    if (is_mirror || !has_peak(x)) return lit;
    float alpha = peak_alpha(x);
    Lobes f = lobes(x, lit.m, wo);
    lit.gloss = min(largest(f.specular) / max(largest(f.diffuse), 1e-6), max_gloss);
    lit.alpha2 = alpha * alpha;
    return lit;
}

// The light that an ideal mirror shows, see mirrored.glsl.
vec3 mirrored_from_one(Surface x, vec3 wo, float u) {
    vec3 m = reflect(-wo, x.n);
    if (!(cosine(x, m) > 0.0)) return vec3(0.0);
    MetLight met = met_light(x, lit_point(x, wo), m, 0.0, u);
    if (met.k < 0 || !is_at_work(met.k)) return vec3(0.0);
    return seen(x.base_color * met.weight * met.light.Li_over_p, x, m, met.light.distance, met.k, towards_light);
}

// The light of choice number i, over the number of choices.
vec3 reflected_from_choice(int i, Surface x, LitPoint lit, vec3 wo, bool samples_brdf, vec2 u, float fresh) {
    u.x = (u.x + float(i)) / float(light_choices);
    LightChoice choice = choose_light(lit, u, fresh);
    if (choice.light < 0 || !is_at_work(choice.light)) return vec3(0.0);
    LightSample light = sample_light(choice.light, x.position, u);
    bool shares = samples_brdf && light.p > 0.0;
    float p = float(light_choices) * choice.P * light.p;
    float weight = shares ? power_heuristic(p, pdf_f_r(x, light.wi, wo)) : 1.0;
    weight /= choice.P * float(light_choices);
    return weighted_integrand(weight, x, light, wo, choice.light, towards_light + i);
}

vec3 reflected(Surface x, vec3 wo) {
    vec2 further = further_random_point(further_numbers);
    if (is_mirror) return mirrored_from_one(x, wo, further.x);
    bool samples_brdf = has_lights_to_meet && has_peak(x);

    LitPoint lit = lit_point(x, wo);
    vec3 L_r = vec3(0.0);
    vec2 u = random_point(1u);
    for (int i = 0; i < light_choices; ++i)
        L_r += reflected_from_choice(i, x, lit, wo, samples_brdf, u, fract(further.y + 0.618034 * float(i)));
    if (!samples_brdf) return L_r;

    vec3 w_brdf = sample_f_r(x, wo, random_point(0u));
    float p_brdf = pdf_f_r(x, w_brdf, wo);
    if (!(p_brdf > 0.0 && cosine(x, w_brdf) > 0.0)) return L_r;
    MetLight met = met_light(x, lit, w_brdf, p_brdf, further.x);
    if (met.k < 0 || !is_at_work(met.k)) return L_r;
    return L_r + weighted_integrand(met.weight, x, met.light, wo, met.k, towards_light + light_choices);
}
