// Quadrature points of an emitter, from its outline.
//
// They form a fan: along the outline in equal steps (the midpoint rule), and from its centre o to the outline's
// point b at two distances (Gauss's rule of two points in 1 - cosψ, the angle from o). A point's weight is its solid
// angle, dω = o·(b×b') / (1 + o·b) du ds for cosψ = 1 - u (1 - o·b). They are smooth in all that they depend on, none
// leaves the outline, and visibility can use them.
#include "light/visible_outline.glsl"

// Number of the `wanted` steps along the outline that belong to an arc; at least one.
int steps_of(Arc arc, VisibleOutline v, int wanted) {
    if (!(arc.to > arc.from)) return 0;
    float arc_length = has_cones ? middle_and_length(arc).w : arc.to - arc.from;
    return max(1, int(float(wanted) * arc_length / v.girth + 0.5));
}

const int points_a_step = 2;

// A step of the fan: what its points have in common.
struct QuadratureStep {
    vec3 outwards; // unit, from the centre along the fan
    float reach;   // 1 - cosψ of the outline
    float weight;  // solid angle of one of its points [sr]
};

// At step `at` of `steps`, whose middle is 0.5 further.
QuadratureStep quadrature_step(Arc arc, float at, int steps, vec3 center) {
    float width = (arc.to - arc.from) / float(steps);
    vec3 b, turn;
    arc_at(arc, arc.from + at * width, b, turn);
    float cosine = dot(center, b);
    vec3 outwards = b - cosine * center;
    float l = length(outwards);
    vec3 chord = b - center;
    return QuadratureStep(l > 0.0 ? outwards / l : vec3(0.0), 0.5 * dot(chord, chord),
                   max(dot(center, turn), 0.0) * width / (float(points_a_step) * (1.0 + cosine)));
}

// The place of point i of points_a_step between centre and outline: Gauss's rule on [0, 1].
float quadrature_distance(int i) { return 0.5 + (i == 0 ? -0.5 : 0.5) / sqrt(3.0); }

vec3 quadrature_point(QuadratureStep slice, float distance, vec3 center) {
    float rise = slice.reach * distance; // 1 - cosψ
    return (1.0 - rise) * center + sqrt(rise * (2.0 - rise)) * slice.outwards;
}
