// The light that a direction meets. Where it meets several, one of them is kept by chance (reservoir sampling, Chao
// 1982), with a probability in proportion to what each would add; so one shadow ray serves.
//
// The tree's boxes are walked as those of visibility/bvh.glsl are. Lights do not hide one another here: V does that.
#include "surface/surface.glsl"
#include "integrator/power_heuristic.glsl"
#include "interface/estimator.glsl"
#include "interface/frame.glsl"
#include "light/mesh_along.glsl"
#include "light/sample_light.glsl"
#include "light/tree.glsl"

struct MetLight {
    int k;             // negative: none is met
    LightSample light;
    float weight;      // of its integrand
};

const MetLight none_met = MetLight(-1, no_light, 0.0);

// Returns whether the ray from x along w meets the box of the node.
bool meets_box(int node, vec3 x, vec3 inverse_w) {
    vec3 t_low = (texelFetch(light_table, node).xyz - x) * inverse_w;
    vec3 t_high = (texelFetch(light_table, node + 1).xyz - x) * inverse_w;
    vec3 enter = min(t_low, t_high);
    vec3 leave = max(t_low, t_high);
    return max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(leave.x, min(leave.y, leave.z));
}

LightSample met_by(int k, Surface x, vec3 w) {
    if (is_mirror && has_mesh_lights && light_at(k).kind == mesh_light) return mesh_along(light_at(k), x.position, w);
    return light_along(k, x.position, w);
}

// The weight of an integrand over light.p, where the direction came with density p_w, or from a mirror with certainty.
float weight_of_direction(int k, Surface x, LightSample light, float p_w) {
    if (is_mirror) return light.p;
    float choices = float(light_choices) * p_light(k, x.position, x.n);
    return choices > 0.0 ? power_heuristic_over(p_w, choices * light.p) / choices : light.p / p_w;
}

MetLight met_light(Surface x, vec3 w, float p_w, float u) {
    ivec2 tree = light_tree();
    int wanted = is_mirror ? met_form + mesh_form : met_form;
    vec3 inverse_w = 1.0 / mix(w, vec3(1e-30), equal(w, vec3(0.0))); // in place of 0, whose inverse times 0 is no number
    MetLight kept = none_met;
    float sum = 0.0;
    for (int i = 0; i < tree.y;) {
        int node = tree.x + 4 * i;
        int form = int(texelFetch(light_table, node + 2).w);
        bool is_met = (form & wanted) != 0 && ((form & far_form) != 0 || meets_box(node, x.position, inverse_w));
        int link = link_of(node);
        i = is_met && link >= 0 ? i + 1 : int(texelFetch(light_table, node + 3).z);
        if (!is_met || link >= 0) continue;
        LightSample light = met_by(-1 - link, x, w);
        if (!(light.p > 0.0)) continue;
        float weight = weight_of_direction(-1 - link, x, light, p_w);
        float amount = weight * dot(light.Li_over_p, vec3(1.0));
        if (!(amount > 0.0)) continue;
        sum += amount;
        float share = amount / sum;
        bool is_kept = u < share;
        u = is_kept ? u / share : (u - share) / (1.0 - share);
        if (is_kept) kept = MetLight(-1 - link, light, weight / amount);
    }
    kept.weight *= sum;
    return kept;
}

// Returns whether light k is at work (Frame).
bool is_at_work(int k) { return k >= first_light && k < end_light; }
