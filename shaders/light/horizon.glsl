// Clipping of an outline's piece at the horizon z = 0.
#include "light/cone_outline.glsl"

struct Piece {
    Arc arc;
    bool is_cut_at_start; // there it leaves the horizon
    bool is_cut_at_end;   // there it meets it
};

const Piece hidden = Piece(no_arc, true, true);

// The straight piece from p to q = p + edge. Neighbouring pieces give their common corner by the same numbers, so that both find it
// on the same side of the horizon; the digits of small far pieces are in the edge.
Piece straight_piece(vec3 p, vec3 q, vec3 edge) {
    bool is_cut_at_start = p.z < 0.0;
    bool is_cut_at_end = q.z < 0.0;
    if (is_cut_at_start && is_cut_at_end) return hidden;
    float t = p.z / (p.z - q.z);
    if (is_cut_at_end) {
        edge *= t;
        q = p + edge;
    }
    if (is_cut_at_start) {
        p += t * edge;
        edge *= 1.0 - t;
    }
    vec3 turn = cross(p, edge); // p×q with all its digits
    float sine = length(turn);
    if (sine == 0.0) return Piece(no_arc, false, false); // no length, so no gap either
    vec3 x = normalize(p);
    vec3 z = turn / sine;
    Arc arc = Arc(mat3(x, cross(z, x), z), vec3(1.0, 1.0, 0.0), 0.0, angle_of(vec2(dot(p, q), sine)));
    return Piece(arc, is_cut_at_start, is_cut_at_end);
}

// (ψ where the cone rises above the horizon, ψ where it sets); the second is the greater. Only for a cone that crosses
// the horizon.
vec2 horizon_of(Arc arc) {
    vec3 k = vec3(arc.axes[0].z, arc.axes[1].z, arc.axes[2].z) * arc.size; // z = k.z + k.x cosφ + k.y sinφ
    float s = sqrt(max(dot(k.xy, k.xy) - k.z * k.z, 0.0));
    vec2 radii = arc_radii(arc);
    float rise = angle_of(radii * (-k.z * k.xy + s * vec2(k.y, -k.x)));
    float set = angle_of(radii * (-k.z * k.xy + s * vec2(-k.y, k.x)));
    return vec2(rise, set > rise ? set : set + 2.0 * pi);
}

// Angle at which the cone is lowest.
float lowest_angle(Arc arc) {
    return angle_of(-arc_radii(arc) * vec2(arc.axes[0].z * arc.size.x, arc.axes[1].z * arc.size.y));
}

// A whole cone, or an arc that has its lowest point at an end.
Piece round_piece(Arc arc) {
    if (!(arc.to > arc.from)) return Piece(arc, false, false);
    float middle = arc.axes[2].z * arc.size.z;
    float swing = length(vec2(arc.axes[0].z * arc.size.x, arc.axes[1].z * arc.size.y));
    if (middle >= swing) return Piece(arc, false, false);
    if (middle <= -swing) return hidden;
    vec2 visible = horizon_of(arc);
    if (arc.to - arc.from >= 2.0 * pi) return Piece(Arc(arc.axes, arc.size, visible.x, visible.y), true, true);
    float from = 0.0;
    float to = 0.0;
    for (int turns = -1; turns <= 1; ++turns) { // ψ repeats: the overlap is with one of its copies
        vec2 v = visible + 2.0 * pi * float(turns);
        float start = max(arc.from, v.x);
        float end = min(arc.to, v.y);
        if (end - start > to - from) {
            from = start;
            to = end;
        }
    }
    if (to <= from) return hidden;
    return Piece(Arc(arc.axes, arc.size, from, to), from != arc.from, to != arc.to);
}
