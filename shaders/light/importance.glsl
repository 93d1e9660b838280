// An estimate of the light that a node of the light tree sends to x and on to the viewer, from its bounds:
//
//   I(x, node) = Φ cosθ_i cosθ f(w) / (d² + r²/3)      where θ' < θ_e and a part of the box is above x, otherwise 0
//   θ' = max(0, θ - θ_o - θ_b)                          the least angle between an emitter's normal and the way to x
//   f(w) = 1 + s/5 α²/α'² (α'² / (sin²θ_h + α'² cos²θ_h))²      α'² = α² + sin²θ_b / 12
//
// after Conty Estevez & Kulla 2018, section 5.1, and Pharr, Jakob & Humphreys 2023, section 12.6.3: Φ is the intensity of
// the node's lights, d and w lead to the middle of its box, r is half the box's diagonal, sinθ_b = r / d, θ_o is half
// the cone of normals, θ_e how far from its normal an emitter sends light. Those bound the amount; noise is less where it
// is a mean over the node: d² + r²/3 is the mean square of the distance to the points of the box, cosθ_i is halfway
// between those of the highest point and the middle, and cosθ between cosθ' and that of the axis, the nearer to cosθ'
// the wider the cone. f is f_r over its diffuse part: GGX's D (Walter et al. 2007, Eq. 33), widened by the node's size,
// of the half vector. Of the peak a fifth counts, since the BRDF's own direction finds it, too. Lights at infinity have
// the irradiance E cosθ_i f. Only what cannot shine on x is dark; a cosine is min_cosine at least. Keep in sync with
// src/render/gpu/light_tree.hpp.
#include "interface/features.glsl"
#include "interface/lights.glsl"

const float min_cosine = 0.01;
const float peak_share = 0.2;
const float max_importance = 1e30; // two of them are a float

const int two_sided_form = 1;
const int far_form = 2;  // at infinity
const int met_form = 4;  // a direction of the BRDF's choice can meet a light
const int mesh_form = 8; // an ideal mirror's can meet a mesh
const int front_form = 16; // all emitters face one way and send nothing behind their plane

const bool has_far_lights = has_directional_lights || has_environment_lights;

// A point that lights shine on.
struct LitPoint {
    vec3 position; // x [m]
    vec3 n;
    vec3 m;        // where its BRDF has its peak
    float gloss;   // s: f_r along m over the diffuse f_r
    float alpha2;  // of the peak
};

const int texels_per_node = 5;

int light_tree_size() { return light_tree().y; } // in nodes

// The first texel of node number i.
int node_of(int i) { return light_tree().x + texels_per_node * i; }

// cos(max(0, a - b)) of angles in [0, π], from their cosines and the sine of b.
float cos_of_difference(float cos_a, float cos_b, float sin_b) {
    return cos_a > cos_b ? 1.0 : cos_a * cos_b + sqrt(max(1.0 - cos_a * cos_a, 0.0)) * sin_b;
}

// f(w) from the cosine of the angle between w and m, of which half is that of the half vector, for a node of this size.
float peak_towards(LitPoint x, float cos_m, float sin_b) {
    float sin2_h = max(0.5 - 0.5 * cos_m, 0.0);
    float a2 = x.alpha2 + sin_b * sin_b / 12.0;
    float d = a2 / mix(sin2_h, 1.0, a2);
    return 1.0 + peak_share * x.gloss * x.alpha2 / a2 * d * d;
}

float importance_of_far(LitPoint x, float power, vec3 axis, float cos_o, float sin_o) {
    float cos_i = has_diffuse_transmission ? 1.0 : cos_of_difference(dot(x.n, axis), cos_o, sin_o);
    if (!(cos_i > -min_cosine)) return 0.0;
    return power * max(cos_i, min_cosine) * peak_towards(x, dot(x.m, axis), cos_o > 0.0 ? sin_o : 1.0);
}

// The importance of the node whose first texel is `node`.
float importance(int node, LitPoint x) {
    vec4 center = texelFetch(light_table, node);        // w: Φ
    vec4 half_size = texelFetch(light_table, node + 1); // w: link
    vec4 axis = texelFetch(light_table, node + 2);      // w: form
    vec4 cone = texelFetch(light_table, node + 3);      // cosθ_o, sinθ_o, cosθ_e, half the box's diagonal [m]
    int form = int(axis.w);
    if (has_far_lights && (form & far_form) != 0) return importance_of_far(x, center.w, axis.xyz, cone.x, cone.y);
    vec3 to_center = center.xyz - x.position;
    float inverse_d = inversesqrt(max(dot(to_center, to_center), 1e-30));
    vec3 w = to_center * inverse_d;
    float above = dot(x.n, to_center); // the middle's height above the surface, and the highest point's
    float highest = above + dot(abs(x.n), half_size.xyz);
    float depth = -dot(axis.xyz, to_center) + dot(abs(axis.xyz), half_size.xyz); // of x below the emitters' plane
    bool is_dark = (!has_diffuse_transmission && !(highest > 0.0)) || ((form & front_form) != 0 && !(depth > 0.0));
    float sin_b = min(cone.w * inverse_d, 1.0);
    float cos_b = sqrt(1.0 - sin_b * sin_b);
    float cos_w = -dot(axis.xyz, w);
    if ((form & two_sided_form) != 0) cos_w = abs(cos_w);
    float sin_sum = cone.y * cos_b + cone.x * sin_b; // of θ_o + θ_b; below 0: all around
    float cos_y = cos_of_difference(cos_w, cone.x * cos_b - cone.y * sin_b, sin_sum);
    if (sin_b == 1.0 || !(sin_sum >= 0.0)) cos_y = 1.0;
    if (is_dark || cos_y < cone.z) return 0.0;
    float cos_i = has_diffuse_transmission ? 1.0 : min(0.5 * (max(above, 0.0) + highest) * inverse_d, 1.0);
    cos_y = mix(cos_y, max(cos_w, 0.0), 0.5 * max(cone.x, 0.0));
    float d2 = dot(to_center, to_center) + cone.w * cone.w / 3.0;
    float f = peak_towards(x, dot(x.m, w), sin_b);
    return min(center.w * max(cos_i, min_cosine) * max(cos_y, min_cosine) * f / max(d2, 1e-30), max_importance);
}
