// The light that a direction meets. Where it meets several, one of them is kept by chance (reservoir sampling, Chao
// 1982), with a probability in proportion to its radiance; so one shadow ray serves.
//
// The tree's boxes are walked as those of visibility/bvh.glsl are. Pixels that run together all wait for the longest way
// to a leaf, and only then look at their lights (Aila & Laine 2009, section 3: "while-while"). Lights do not hide one
// another here: V does that.
#include "surface/surface.glsl"
#include "integrator/power_heuristic.glsl"
#include "interface/estimator.glsl"
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
    vec3 middle = (texelFetch(light_table, node).xyz - x) * inverse_w;
    vec3 reach = texelFetch(light_table, node + 1).xyz * abs(inverse_w);
    vec3 enter = middle - reach;
    vec3 leave = middle + reach;
    return max(max(enter.x, enter.y), max(enter.z, 0.0)) <= min(leave.x, min(leave.y, leave.z));
}

// The first node from number i on that is a leaf whose box the ray meets; the number of nodes, if there is none.
int next_leaf(int i, int size, vec3 x, vec3 inverse_w) {
    int wanted = is_mirror ? met_form + mesh_form : met_form;
    int leaf = size;
    while (i < size) {
        int node = node_of(i);
        int form = int(texelFetch(light_table, node + 2).w);
        bool is_met = (form & wanted) != 0 && ((form & far_form) != 0 || meets_box(node, x, inverse_w));
        bool is_leaf = link_of(node) < 0;
        if (is_met && is_leaf) leaf = i;
        i = is_met ? is_leaf ? size : i + 1 : end_of(node);
    }
    return leaf;
}

LightSample met_by(int k, Surface x, vec3 w) {
    if (is_mirror && has_mesh_lights && light_at(k).kind == mesh_light) return mesh_along(light_at(k), x.position, w);
    return light_along(k, x.position, w);
}

// The weight of an integrand over light.p, where the direction came with density p_w, or from a mirror with certainty.
float weight_of_direction(int k, LitPoint x, LightSample light, float p_w) {
    if (is_mirror) return light.p;
    float choices = float(light_choices) * p_light(k, x);
    return choices > 0.0 ? power_heuristic_over(p_w, choices * light.p) / choices : light.p / p_w;
}

MetLight met_light(Surface x, LitPoint lit, vec3 w, float p_w, float u) {
    int size = light_tree_size();
    vec3 inverse_w = 1.0 / mix(w, vec3(1e-30), equal(w, vec3(0.0))); // in place of 0, whose inverse times 0 is no number
    MetLight kept = none_met;
    float L_kept = 0.0;
    float sum = 0.0;
    for (int i = 0; i < size;) {
        i = next_leaf(i, size, x.position, inverse_w);
        if (i >= size) break;
        int node = node_of(i);
        i = end_of(node);
        int k = -1 - link_of(node);
        LightSample light = met_by(k, x, w);
        float L = light.p * dot(light.Li_over_p, vec3(1.0));
        if (!(L > 0.0)) continue;
        sum += L;
        float share = L / sum;
        bool is_kept = u < share;
        u = is_kept ? u / share : (u - share) / (1.0 - share);
        if (!is_kept) continue;
        kept = MetLight(k, light, 0.0);
        L_kept = L;
    }
    if (kept.k >= 0) kept.weight = weight_of_direction(kept.k, lit, kept.light, p_w) * (sum / L_kept);
    return kept;
}
