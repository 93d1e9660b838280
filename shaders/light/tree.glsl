// The light tree: x chooses one light of all, with a probability near the share of what it sends.
//
// From the root on, a child is chosen by its share of the importance of both (light/importance.glsl). Keep in sync with
// src/render/gpu/light_tree.hpp.
#include "light/importance.glsl"

const int max_light_tree_depth = 64;
const float min_share = 1e-6; // of a child that is not dark; random numbers have steps of 6e-8
const float largest_below_one = 0.99999994;

// The probability of the first of two children of these importances.
float share_of(float first, float second) {
    float sum = first + second;
    if (!(sum > 0.0)) return 0.5;
    float share = first / sum;
    return first > 0.0 && second > 0.0 ? clamp(share, min_share, 1.0 - min_share) : share;
}

int link_of(int node) { return int(texelFetch(light_table, node + 1).w); } // the second child, or -1 - light
int end_of(int node) { return int(texelFetch(light_table, node + 4).x); } // one past the last node of its subtree

struct LightChoice {
    int light; // negative: no light sends out anything
    float P;   // its probability
};

// u.x chooses, and becomes its place within the part of [0, 1) that chooses this light, for a point on it. Where little
// of its 24 bits is left, `fresh` replaces it, another random number.
LightChoice choose_light(LitPoint x, inout vec2 u, float fresh) {
    if (light_tree_size() == 0) return LightChoice(-1, 0.0);
    int root = node_of(0);
    int node = root;
    float P = 1.0;
    bool is_fresh = false;
    int link = link_of(node);
    for (int depth = 0; link >= 0 && depth < max_light_tree_depth; ++depth) {
        int first = node + texels_per_node;
        int second = root + texels_per_node * link;
        float share = share_of(importance(first, x), importance(second, x));
        bool is_first = u.x < share;
        u.x = min(is_first ? u.x / share : (u.x - share) / (1.0 - share), largest_below_one);
        P *= is_first ? share : 1.0 - share;
        link = is_first ? link_of(first) : link_of(second);
        node = is_first ? first : second;
        if (!is_fresh && P < 1.0 / 1024.0) {
            is_fresh = true;
            u.x = fresh;
        }
    }
    return LightChoice(-1 - link, P);
}

// The probability with which x chooses light k.
float p_light(int k, LitPoint x) {
    int root = node_of(0);
    int at = leaf_of(k);
    if (at < 0) return 0.0;
    float P = 1.0;
    for (int depth = 0; at > 0 && depth < max_light_tree_depth; ++depth) {
        int parent = int(texelFetch(light_table, root + texels_per_node * at + 4).y);
        int first = root + texels_per_node * (parent + 1);
        int second = root + texels_per_node * link_of(first - texels_per_node);
        float share = share_of(importance(first, x), importance(second, x));
        P *= at == parent + 1 ? share : 1.0 - share;
        at = parent;
    }
    return P;
}
