// The density with which sample_tube finds a direction: its steps backwards.
#include "light/tube.glsl"

// Returns whether wi meets the tube, which is not seen end on.
bool meets_tube(Tube tube, vec3 wi) {
    vec3 across = wi - dot(wi, tube.axis) * tube.axis;
    float a = dot(across, across);
    float b = dot(tube.foot, across);
    float discriminant = b * b - a * tube.tangent * tube.tangent;
    if (b <= 0.0 || discriminant < 0.0) return false;
    float s = (b - sqrt(discriminant)) / a * dot(wi, tube.axis);
    if (s >= tube.ends.x && s <= tube.ends.y) return true;
    vec3 center = tube.foot + (s < tube.ends.x ? tube.ends.x : tube.ends.y) * tube.axis;
    vec3 off = center - dot(wi, center) * wi;
    return dot(wi, center) > 0.0 && dot(off, off) <= tube.radius * tube.radius;
}

// The angle at which the plane with normal n through x cuts the arc.
float cut_arc(Tube tube, EndCircle c, vec3 n) {
    float A = c.radius * dot(n, c.outward);
    float B = c.radius * dot(n, tube.side);
    float turn = acos(clamp(-dot(n, c.middle) * inversesqrt(A * A + B * B), -1.0, 1.0));
    vec2 cuts = mod(atan(B, A) + vec2(-turn, turn) + pi, 2.0 * pi) - pi;
    vec2 outside = abs(cuts - clamp(cuts, 0.0, c.phi)); // one of the two is on the arc, but for rounding
    return clamp(outside.x < outside.y ? cuts.x : cuts.y, 0.0, c.phi);
}

float p_tube(Tube tube, vec3 wi) {
    if (dot(wi, tube.side) < 0.0) tube.side = -tube.side;
    Pieces pieces = pieces_of(tube);
    vec3 n = cross(tube.o, wi); // the outline at wi's azimuth around o lies in this plane
    vec3 start = rim_on_line(tube, pieces.chi.x).b;
    vec3 end = rim_on_line(tube, pieces.chi.y).b;
    // Seen along o, the pieces of this side come in their order, and turn n·b > 0 where b comes after wi.
    float turn = dot(tube.o, cross(tube.side, tube.axis)) > 0.0 ? 1.0 : -1.0;
    if (turn * dot(n, start) > 0.0) return arc_at(tube, pieces.first, pieces.share.x, cut_arc(tube, pieces.first, n)).p;
    if (turn * dot(n, end) < 0.0) return arc_at(tube, pieces.last, pieces.share.z, cut_arc(tube, pieces.last, n)).p;
    float chi = atan(-dot(n, touching(tube)) / dot(n, tube.axis));
    return line_at(tube, pieces, clamp(chi, pieces.chi.x, pieces.chi.y)).p;
}

LightSample tube_along(Light light, vec3 x, vec3 wi) {
    Tube tube = tube_from(light, x);
    if (!is_end_on(tube)) {
        if (!meets_tube(tube, wi)) return no_light;
        return light_sample(wi, distance_to_tube(tube, wi), light.quantity, p_tube(tube, wi));
    }
    vec3 center = nearer_ball(tube);
    float sin2 = tube.radius * tube.radius / dot(center, center);
    vec3 off = center - dot(wi, center) * wi;
    if (!(sin2 < 1.0) || dot(wi, center) <= 0.0 || dot(off, off) > tube.radius * tube.radius) return no_light;
    return light_sample(wi, distance_to_tube(tube, wi), light.quantity, p_cone(one_minus_cos(sin2)));
}
