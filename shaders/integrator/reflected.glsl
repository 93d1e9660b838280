// The reflection equation for light that comes straight from emitters:
//
//   L_r(x, wo) = Σ_k ∫ f_r(x, wi, wo) L_i(x, wi) V(x, y) cosθ_i dω_i
//
// Each integral by two points a frame, one where the light is and one where the BRDF has its peak, weighed by the
// power heuristic (Veach & Guibas 1995, section 5.2, β = 2); emitters without extent are known exactly and take one.
// Frames add up to the integral. This is the only loop over lights; integrand.glsl has the only cosine. Each kind of light
// has a loop of its own: drivers that run many pixels at once run all that a loop may take, for each light.
#include "surface/surface.glsl"
#include "brdf/brdf.glsl"
#include "integrator/at_work.glsl"
#include "integrator/integrand.glsl"
#include "integrator/mirrored.glsl"
#include "integrator/power_heuristic.glsl"
#include "integrator/random_point.glsl"
#include "integrator/rays.glsl"
#include "integrator/shadowed.glsl"
#include "light/sample_light.glsl"

// The direction of the BRDF's choice.
struct Chosen {
    bool is_taken;
    vec3 wi;
    float p; // its density [1/sr]
};

const Chosen none_chosen = Chosen(false, vec3(0.0), 0.0);

// The part of the lights of this kind; of all, if it is any_kind.
vec3 reflected_from(int kind, Surface x, vec3 wo, Chosen chosen) {
    vec3 L_r = vec3(0.0);
    for (int k = first_at_work(kind); k < end_light; k = next_at_work(k)) {
        Light light = light_at_work(k, kind);
        vec2 u = has_area_lights ? random_point(uint(k) + 1u) : vec2(0.0);
        LightSample from_light = sample_light(light, x.position, u);
        bool shares = chosen.is_taken && from_light.p > 0.0;
        float weight = shares ? power_heuristic(from_light.p, pdf_f_r(x, from_light.wi, wo)) : 1.0;
        vec3 L = weighted_integrand(weight, x, from_light, wo, k, towards_light);

        LightSample along = no_light;
        if (is_met(kind) && chosen.is_taken) along = light_along(light, x.position, chosen.wi);
        if (along.p > 0.0 && chosen.p > 0.0) { // the point came with density chosen.p, so that is what the integrand is over
            L += weighted_integrand(power_heuristic_over(chosen.p, along.p), x, along, wo, k, along_brdf);
        }
        L_r += shadowed(L, k, x, wo);
    }
    return L_r;
}

vec3 reflected(Surface x, vec3 wo) {
    if (is_mirror) return mirrored(x, wo);
    Chosen chosen = none_chosen;
    if (has_lights_to_meet && has_peak(x)) {
        vec3 wi = sample_f_r(x, wo, random_point(0u));
        chosen = Chosen(true, wi, pdf_f_r(x, wi, wo));
    }
    if (!has_loop_for_each_kind) return reflected_from(any_kind, x, wo, chosen);
    vec3 L_r = vec3(0.0);
    if (has_point_lights) L_r += reflected_from(point_light, x, wo, chosen);
    if (has_spot_lights) L_r += reflected_from(spot_light, x, wo, chosen);
    if (has_directional_lights) L_r += reflected_from(directional_light, x, wo, chosen);
    if (has_rectangle_lights) L_r += reflected_from(rectangle_light, x, wo, chosen);
    if (has_disk_lights) L_r += reflected_from(disk_light, x, wo, chosen);
    if (has_sphere_lights) L_r += reflected_from(sphere_light, x, wo, chosen);
    if (has_tube_lights) L_r += reflected_from(tube_light, x, wo, chosen);
    if (has_polygon_lights) L_r += reflected_from(polygon_light, x, wo, chosen);
    if (has_mesh_lights) L_r += reflected_from(mesh_light, x, wo, chosen);
    if (has_environment_lights) L_r += reflected_from(environment_light, x, wo, chosen);
    return L_r;
}
