// An outline cut at the horizon z = 0 and closed along it: its irradiance, and the points of the emitter.
//
//   E / L = 1/2 Σ_pieces n·∫ b×b' dψ        (Stokes; Lambert 1760 for polygons), exact for every piece
//
// Points come in a fan: along the outline in equal steps (the midpoint rule), and from its centre o to the outline's
// point b at two distances (Gauss's rule of two points in 1 - cosψ, the angle from o). A point's weight is its solid
// angle, dω = o·(b×b') / (1 + o·b) du ds for cosψ = 1 - u (1 - o·b). They are smooth in all that they depend on, none
// leaves the outline, and visibility can use them.
#include "light/outline.glsl"

struct VisibleOutline {
    float E;        // irradiance for L = 1 [sr]: 0 where nothing is to be seen
    float girth;      // along it [rad]
    vec3 center;    // a unit direction inside
    Arc closing;    // the piece along the horizon; empty if the outline stays above
};

// The piece of the horizon from one point of it to another, less than half round.
Arc horizon_arc(vec3 from, vec3 to) {
    vec3 x = normalize(vec3(from.xy, 0.0));
    vec3 z = vec3(0.0, 0.0, 1.0);
    float angle = angle_of(vec2(dot(x.xy, to.xy), x.x * to.y - x.y * to.x));
    return Arc(mat3(x, cross(z, x), z), vec3(1.0, 1.0, 0.0), 0.0, angle < -0.5 * pi ? angle + 2.0 * pi : max(angle, 0.0));
}

// Its length along the outline [rad] and its middle, times that, by two points (of a circle these are opposite).
vec4 middle_and_length(Arc arc) {
    if (!has_cones) return (arc.to - arc.from) * vec4(arc_direction(arc, 0.5 * (arc.from + arc.to)), 1.0);
    float width = 0.5 * (arc.to - arc.from);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 2; ++i) {
        vec3 b, turn;
        arc_at(arc, arc.from + (float(i) + 0.5) * width, b, turn);
        sum += length(turn) * width * vec4(b, 1.0);
    }
    return sum;
}

VisibleOutline visible_part(Outline outline) {
    VisibleOutline v = VisibleOutline(0.0, 0.0, vec3(0.0), no_arc);
    vec4 middle = vec4(0.0);
    bool any = false;           // visible so far
    bool is_hidden = false;     // since the last visible end
    bool begins_hidden = false;
    bool is_closed = false;
    vec3 start = vec3(0.0);     // of the first visible piece
    vec3 end = vec3(0.0);       // of the last so far
    for (int k = 0; k < outline.count; ++k) {
        Piece piece = piece_at(outline, k);
        Arc arc = piece.arc;
        if (!(arc.to > arc.from)) {
            is_hidden = is_hidden || piece.is_cut_at_start;
            continue;
        }
        vec3 b = arc_direction(arc, arc.from);
        is_hidden = is_hidden || piece.is_cut_at_start;
        if (!any) {
            start = b;
            begins_hidden = is_hidden;
        } else if (is_hidden) {
            v.closing = horizon_arc(end, b);
            is_closed = true;
        }
        any = true;
        end = arc_direction(arc, arc.to);
        is_hidden = piece.is_cut_at_end;
        v.E += 0.5 * arc_projection(arc);
        middle += middle_and_length(arc);
    }
    if (any && !is_closed && (begins_hidden || is_hidden)) v.closing = horizon_arc(end, start);
    if (v.closing.to > 0.0) {
        v.E += 0.5 * v.closing.to;
        middle += middle_and_length(v.closing);
    }
    v.E = any ? max(v.E, 0.0) : 0.0;
    if (any) v.center = normalize(middle.xyz);
    v.girth = middle.w;
    return v;
}

// How many of `wanted` steps along the outline fall to an arc; one at least.
int steps_of(Arc arc, VisibleOutline v, int wanted) {
    if (!(arc.to > arc.from)) return 0;
    float arc_length = has_cones ? middle_and_length(arc).w : arc.to - arc.from;
    return max(1, int(float(wanted) * arc_length / v.girth + 0.5));
}

const int points_a_step = 2;

// A step of the fan: what its points have in common.
struct FanStep {
    vec3 outwards; // unit, from the centre along the fan
    float reach;   // 1 - cosψ of the outline
    float weight;  // solid angle of one of its points [sr]
};

// At step `at` of `steps`, whose middle is 0.5 further.
FanStep fan_step(Arc arc, float at, int steps, vec3 center) {
    float width = (arc.to - arc.from) / float(steps);
    vec3 b, turn;
    arc_at(arc, arc.from + at * width, b, turn);
    float cosine = dot(center, b);
    vec3 outwards = b - cosine * center;
    float l = length(outwards);
    vec3 chord = b - center;
    return FanStep(l > 0.0 ? outwards / l : vec3(0.0), 0.5 * dot(chord, chord),
                   max(dot(center, turn), 0.0) * width / (float(points_a_step) * (1.0 + cosine)));
}

// The place of point i of points_a_step between centre and outline: Gauss's rule on [0, 1].
float fan_distance(int i) { return 0.5 + (i == 0 ? -0.5 : 0.5) / sqrt(3.0); }

vec3 fan_point(FanStep fan, float distance, vec3 center) {
    float rise = fan.reach * distance; // 1 - cosψ
    return (1.0 - rise) * center + sqrt(rise * (2.0 - rise)) * fan.outwards;
}
