// An outline cut at the horizon z = 0 and closed along it, and its irradiance.
//
//   E / L = 1/2 Σ_pieces n·∫ b×b' dψ        (Stokes; Lambert 1760 for polygons), exact for every piece
#include "light/outline.glsl"

struct VisibleOutline {
    float E;        // irradiance for L = 1 [sr]: 0 where nothing is to be seen
    float girth;      // along it [rad]
    vec3 center;    // a unit direction inside
    Arc closing;    // the piece along the horizon; empty if the outline stays above
};

// Angle along the horizon, counter-clockwise, from one point of it to another [rad]: at most π, which rounding may exceed;
// negative where it leads back.
float horizon_angle(vec3 from, vec3 to) {
    float angle = angle_of(vec2(dot(from.xy, to.xy), from.x * to.y - from.y * to.x));
    return angle < -0.99 * pi ? angle + 2.0 * pi : angle;
}

Arc horizon_arc(vec3 from, float angle) {
    vec3 x = normalize(vec3(from.xy, 0.0));
    vec3 z = vec3(0.0, 0.0, 1.0);
    return Arc(mat3(x, cross(z, x), z), vec3(1.0, 1.0, 0.0), 0.0, angle);
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

// Closes a gap along the horizon. A convex outline has one gap. Where an edge lies on the horizon, rounding makes several, and some
// lead back. All of them count for E, so that they cancel. The longest is the closing piece.
void close_gap(inout VisibleOutline v, vec3 from, vec3 to) {
    float angle = horizon_angle(from, to);
    v.E += 0.5 * angle;
    if (angle > v.closing.to) v.closing = horizon_arc(from, angle);
}

VisibleOutline visible_part(Outline outline) {
    VisibleOutline v = VisibleOutline(0.0, 0.0, vec3(0.0), no_arc);
    vec4 middle = vec4(0.0);
    bool any = false;           // visible so far
    bool is_hidden = false;     // since the last visible end
    bool begins_hidden = false;
    vec3 start = vec3(0.0);     // of the first visible piece
    vec3 end = vec3(0.0);       // of the last so far
    for (int k = 0; k < outline.count; ++k) {
        Piece piece = piece_at(outline, k);
        Arc arc = piece.arc;
        is_hidden = is_hidden || piece.is_cut_at_start;
        if (!(arc.to > arc.from)) continue;
        vec3 b = arc_direction(arc, arc.from);
        if (!any) {
            start = b;
            begins_hidden = is_hidden;
        } else if (is_hidden) {
            close_gap(v, end, b);
        }
        any = true;
        end = arc_direction(arc, arc.to);
        is_hidden = piece.is_cut_at_end;
        v.E += 0.5 * arc_projection(arc);
        middle += middle_and_length(arc);
    }
    if (any && (begins_hidden || is_hidden)) close_gap(v, end, start);
    if (v.closing.to > 0.0) middle += middle_and_length(v.closing);
    v.E = any && v.E > 0.0 ? min(v.E, pi) : 0.0; // an emitter too small for floats has no E either
    if (any) v.center = normalize(middle.xyz);
    v.girth = middle.w;
    return v;
}

// Piece k of the visible outline; the one after the last is the horizon.
Arc arc_of(Outline outline, VisibleOutline v, int k) {
    Arc arc = v.closing;
    if (k < outline.count) arc = piece_at(outline, k).arc;
    return arc;
}
