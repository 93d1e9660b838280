// The light tree: x chooses one light of all, with a probability near the share of what it sends.
//
//   I(x, node) = Φ |cosθ_i'| cosθ' / d²      where θ' < θ_e, otherwise 0
//   θ_i' = max(0, θ_i - θ_b)                 the least angle to n
//   θ'   = max(0, θ - θ_o - θ_b)             the least angle between an emitter's normal and the way to x
//
// Conty Estevez & Kulla 2018, section 5.1, as Pharr, Jakob & Humphreys 2023, section 12.6.3, bound it: Φ is the
// intensity of the node's lights, θ_b half the angle of the sphere around its box, θ_o that of the cone of normals, and
// θ_e how far from its normal an emitter sends light. Lights at infinity have the irradiance E cosθ_i'. From the root
// on, a child is chosen by its share of both. A node counts as dark only where none of its lights can shine on x; a
// cosine is min_cosine at least. Keep in sync with src/render/gpu/light_tree.hpp.
#include "interface/features.glsl"
#include "interface/lights.glsl"

const int max_light_tree_depth = 64;
const float min_cosine = 0.01;
const float max_importance = 1e30; // two of them are a float
const float min_share = 1e-6;      // of a child that is not dark; random numbers have steps of 6e-8
const float largest_below_one = 0.99999994;

const int two_sided_form = 1;
const int far_form = 2;  // at infinity
const int met_form = 4;  // a direction of the BRDF's choice can meet a light
const int mesh_form = 8; // an ideal mirror's can meet a mesh
const int front_form = 16; // all emitters face one way and send nothing behind their plane

// cos(max(0, a - b)) of angles in [0, π], from their cosines.
float cos_of_difference(float cos_a, float cos_b) {
    if (cos_a > cos_b) return 1.0;
    return cos_a * cos_b + sqrt(max((1.0 - cos_a * cos_a) * (1.0 - cos_b * cos_b), 0.0));
}

// Returns whether a point of the box lies above the plane through x with this normal.
bool reaches_above(vec3 normal, vec3 to_center, vec3 half_size) {
    return dot(normal, to_center) + dot(abs(normal), half_size) > 0.0;
}

// An estimate of the irradiance at x, with the normal n, from the lights of the node whose first texel is `node`.
float importance(int node, vec3 x, vec3 n) {
    vec4 low = texelFetch(light_table, node);      // w: Φ
    vec4 high = texelFetch(light_table, node + 1); // w: link
    vec4 axis = texelFetch(light_table, node + 2); // w: form
    vec4 cone = texelFetch(light_table, node + 3); // cosθ_o, cosθ_e, end, parent
    int form = int(axis.w);
    if ((form & far_form) != 0) {
        float cos_i = has_diffuse_transmission ? 1.0 : cos_of_difference(dot(n, axis.xyz), cone.x);
        return cos_i > -min_cosine ? low.w * max(cos_i, min_cosine) : 0.0;
    }
    vec3 half_size = 0.5 * (high.xyz - low.xyz);
    vec3 to_center = 0.5 * (low.xyz + high.xyz) - x;
    if (!has_diffuse_transmission && !reaches_above(n, to_center, half_size)) return 0.0;
    if ((form & front_form) != 0 && !reaches_above(-axis.xyz, to_center, half_size)) return 0.0;
    float r2 = dot(half_size, half_size);
    float d2 = dot(to_center, to_center);
    vec3 w = to_center * inversesqrt(max(d2, 1e-30));
    float cos_b = d2 > r2 ? sqrt(1.0 - r2 / d2) : -1.0;
    float cos_i = has_diffuse_transmission ? 1.0 : cos_of_difference(dot(n, w), cos_b);
    float cos_w = -dot(axis.xyz, w);
    if ((form & two_sided_form) != 0) cos_w = abs(cos_w);
    float cos_y = cos_of_difference(cos_of_difference(cos_w, cone.x), cos_b);
    if (cos_y < cone.y) return 0.0;
    return min(low.w * max(cos_i, min_cosine) * max(cos_y, min_cosine) / max(max(d2, r2), 1e-30), max_importance);
}

// The probability of the first of two children of these importances.
float share_of(float first, float second) {
    float sum = first + second;
    if (!(sum > 0.0)) return 0.5;
    float share = first / sum;
    return first > 0.0 && second > 0.0 ? clamp(share, min_share, 1.0 - min_share) : share;
}

int link_of(int node) { return int(texelFetch(light_table, node + 1).w); } // the second child, or -1 - light

struct LightChoice {
    int light; // negative: no light sends out anything
    float P;   // its probability
};

// u.x chooses, and becomes its place within the part of [0, 1) that chooses this light, for a point on it. Where little
// of its 24 bits is left, `fresh` replaces it, another random number.
LightChoice choose_light(vec3 x, vec3 n, inout vec2 u, float fresh) {
    ivec2 tree = light_tree();
    if (tree.y == 0) return LightChoice(-1, 0.0);
    int node = tree.x;
    float P = 1.0;
    bool is_fresh = false;
    int link = link_of(node);
    for (int depth = 0; link >= 0 && depth < max_light_tree_depth; ++depth) {
        int first = node + 4;
        int second = tree.x + 4 * link;
        float share = share_of(importance(first, x, n), importance(second, x, n));
        bool is_first = u.x < share;
        u.x = min(is_first ? u.x / share : (u.x - share) / (1.0 - share), largest_below_one);
        P *= is_first ? share : 1.0 - share;
        node = is_first ? first : second;
        link = link_of(node);
        if (!is_fresh && P < 1.0 / 1024.0) {
            is_fresh = true;
            u.x = fresh;
        }
    }
    return LightChoice(-1 - link, P);
}

// The probability with which x chooses light k.
float p_light(int k, vec3 x, vec3 n) {
    int root = light_tree().x;
    int at = leaf_of(k);
    if (at < 0) return 0.0;
    float P = 1.0;
    for (int depth = 0; at > 0 && depth < max_light_tree_depth; ++depth) {
        int parent = int(texelFetch(light_table, root + 4 * at + 3).w);
        int second = link_of(root + 4 * parent);
        float share = share_of(importance(root + 4 * parent + 4, x, n), importance(root + 4 * second, x, n));
        P *= at == second ? 1.0 - share : share;
        at = parent;
    }
    return P;
}
