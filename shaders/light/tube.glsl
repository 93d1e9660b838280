// A tube with round ends (a capsule) of radiance L_e, sampled along the rays from its centre to its outline.
//
//   p(wi) = share p(angle) / (2 W)          [1/sr]
//
// A side of the outline has three pieces, arc, line, arc (tube_outline.glsl); one is chosen by its share of the solid
// angle, as W at its middle has it; on it the angle is distributed as W nearly is, and between the centre o and the
// outline the height 1 - cosψ is uniform. Where x sees the tube end on, within its radius, the nearer ball hides the rest
// and is sampled as a sphere. From within nothing is seen.
#include "light/cone.glsl"
#include "light/light_sample.glsl"
#include "light/tube_outline.glsl"

bool is_end_on(Tube tube) { return tube.rho <= tube.radius; }

// The ball that is seen end on; at the origin where x is inside.
vec3 nearer_ball(Tube tube) {
    if (tube.ends.x <= 0.0 && tube.ends.y >= 0.0) return vec3(0.0);
    return tube.foot + (tube.ends.x > 0.0 ? tube.ends.x : tube.ends.y) * tube.axis;
}

// The pieces of a side in the order in which they go around, and their shares of the solid angle.
struct Pieces {
    EndCircle first;
    EndCircle last;
    vec2 chi;           // where the line starts and ends
    vec3 share;
};

Pieces pieces_of(Tube tube) {
    Pieces p;
    p.first = end_circle(tube, 0);
    p.last = end_circle(tube, 1);
    p.chi = atan(tube.ends, vec2(tube.tangent));
    vec3 W = vec3(rim_on_arc(tube, p.first, 0.25 * pi).W / p_arc(p.first, 0.25 * pi),
                  rim_on_line(tube, 0.5 * (p.chi.x + p.chi.y)).W * (p.chi.y - p.chi.x),
                  rim_on_arc(tube, p.last, 0.25 * pi).W / p_arc(p.last, 0.25 * pi));
    p.share = W / (W.x + W.y + W.z);
    return p;
}

// A point of the outline and its density: that of the angle, over W.
struct RimSample {
    Rim rim;
    float p;
};

RimSample line_at(Tube tube, Pieces pieces, float chi) {
    Rim rim = rim_on_line(tube, chi);
    return RimSample(rim, 0.5 * pieces.share.y / (pieces.chi.y - pieces.chi.x) / rim.W);
}

RimSample arc_at(Tube tube, EndCircle c, float share, float phi) {
    Rim rim = rim_on_arc(tube, c, phi);
    return RimSample(rim, 0.5 * share * p_arc(c, phi) / rim.W);
}

RimSample sample_rim(Tube tube, Pieces pieces, float t) {
    vec3 share = pieces.share;
    if (t < share.x) return arc_at(tube, pieces.first, share.x, sample_arc(pieces.first, t / share.x));
    t -= share.x;
    if (t < share.y) return line_at(tube, pieces, mix(pieces.chi.x, pieces.chi.y, t / share.y));
    return arc_at(tube, pieces.last, share.z, sample_arc(pieces.last, clamp((t - share.y) / share.z, 0.0, 1.0)));
}

// Distance to the tube in direction wi, which hits it up to rounding.
float distance_to_tube(Tube tube, vec3 wi) {
    vec3 across = wi - dot(wi, tube.axis) * tube.axis;
    float a = dot(across, across);
    float b = dot(tube.foot, across);
    float d = a > 0.0 ? (b - sqrt(max(b * b - a * tube.tangent * tube.tangent, 0.0))) / a : 0.0;
    float s = d * dot(wi, tube.axis);
    if (!is_end_on(tube) && s >= tube.ends.x && s <= tube.ends.y) return d;
    vec3 center = is_end_on(tube) ? nearer_ball(tube) : tube.foot + (s < tube.ends.x ? tube.ends.x : tube.ends.y) * tube.axis;
    float middle = dot(wi, center);
    vec3 off = center - middle * wi;
    return middle - sqrt(max(tube.radius * tube.radius - dot(off, off), 0.0));
}

LightSample sample_tube(Light light, vec3 x, vec2 u) {
    Tube tube = tube_from(light, x);
    if (is_end_on(tube)) {
        vec3 center = nearer_ball(tube);
        float sin2 = tube.radius * tube.radius / dot(center, center);
        if (!(sin2 < 1.0)) return no_light;
        vec3 w = sample_cone(normalize(center), one_minus_cos(sin2), u);
        return light_sample(w, distance_to_tube(tube, w), light.quantity, p_cone(one_minus_cos(sin2)));
    }
    if (u.x >= 0.5) tube.side = -tube.side;
    float v = fract(2.0 * u.x);
    RimSample s = sample_rim(tube, pieces_of(tube), v);
    vec3 across = s.rim.b - dot(tube.o, s.rim.b) * tube.o;
    float l2 = dot(across, across);
    float height = u.y * l2 / (1.0 + dot(tube.o, s.rim.b)); // 1 - cosψ
    vec3 wi = normalize((1.0 - height) * tube.o + sqrt(height * (2.0 - height) / l2) * across);
    return light_sample(wi, distance_to_tube(tube, wi), light.quantity, s.p);
}
