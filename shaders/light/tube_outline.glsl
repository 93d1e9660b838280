// The outline of a tube with round ends, as x sees it: on either side a stretch of a straight line, where planes through
// x touch the cylinder, and half of an arc around each end, where cones touch the balls. The two sides mirror each other.
//
// Stretches are told by the angle χ seen from x, arcs by the angle φ around the ball's tangent circle. Between the unit
// direction o to the tube's centre and the outline b lies, per unit of the angle, the solid angle
//
//   W = (1 - cosψ) o·(b × b') / |o × b|² = o·(b × b') / (|b|² (1 + cosψ)),    ψ the angle from o to b.
#include "base/constants.glsl"
#include "interface/lights.glsl"

struct Tube {
    vec3 o;             // unit, towards the centre
    vec3 axis;          // unit
    vec3 side;          // unit, across the axis and the shortest way to it
    vec3 foot;          // from x to the nearest point of the infinite axis [m]
    vec2 ends;          // where the axis ends, told from the foot [m]
    float rho;          // |foot| [m]
    float radius;       // [m]
    float tangent;      // from x to the line that it touches: √(ρ² - r²) [m]
};

Tube tube_from(Light light, vec3 x) {
    vec3 to_center = light.position - x;
    float half_length = length(light.half_u);
    vec3 axis = light.half_u / half_length;
    float along = dot(to_center, axis);
    vec3 foot = to_center - along * axis;
    float rho = length(foot);
    float tangent = sqrt(max(rho * rho - light.radius * light.radius, 0.0));
    return Tube(normalize(to_center), axis, cross(axis, foot) / rho, foot, along + vec2(-half_length, half_length), rho,
                light.radius, tangent);
}

// A point of the outline: its unit direction, and W.
struct Rim {
    vec3 b;
    float W;
};

Rim rim_of(vec3 o, vec3 b, vec3 across) { // across: b × b' / |b|²
    return Rim(b, abs(dot(o, across)) / (1.0 + dot(o, b)));
}

// On the straight stretch of the side that `side` points to, at χ from the foot.
vec3 touching(Tube tube) { // unit, towards the touched line's foot
    return tube.tangent / tube.rho * tube.foot / tube.rho + tube.radius / tube.rho * tube.side;
}

Rim rim_on_line(Tube tube, float chi) {
    vec3 t = touching(tube);
    return rim_of(tube.o, cos(chi) * t + sin(chi) * tube.axis, cross(t, tube.axis));
}

// The tangent circle of the ball at an end (0 or 1): its middle, radius and the direction in its plane that points
// away from the tube; the other direction is `side`. Along its arc o·(b × b') = `even` + `swelling` cosφ.
struct EndCircle {
    vec3 middle;        // [m]
    float radius;       // [m]
    vec3 outward;       // unit
    float distance2;    // from x to the circle, squared [m²]
    float phi;          // half of the arc reaches from 0 to phi
    float even;         // [m²]
    float swelling;     // [m²]
};

EndCircle end_circle(Tube tube, int end) {
    vec3 center = tube.foot + tube.ends[end] * tube.axis;
    float d2 = dot(center, center);
    float shrink = max(1.0 - tube.radius * tube.radius / d2, 0.0);
    vec3 away = float(2 * end - 1) * tube.axis;
    vec3 outward = normalize(away - dot(away, center) / d2 * center);
    float phi = atan(tube.tangent * tube.rho, -tube.radius * dot(tube.foot, outward));
    float r = tube.radius * sqrt(shrink);
    vec3 middle = shrink * center;
    return EndCircle(middle, r, outward, d2 * shrink, phi, r * r * dot(tube.o, center) * inversesqrt(d2),
                     -r * length(middle) * dot(tube.o, outward));
}

Rim rim_on_arc(Tube tube, EndCircle c, float phi) {
    vec3 b = c.middle + c.radius * (cos(phi) * c.outward + sin(phi) * tube.side);
    float W = max(c.even + c.swelling * cos(phi), 0.0) / (c.distance2 + sqrt(c.distance2) * dot(tube.o, b));
    return Rim(b * inversesqrt(c.distance2), W);
}

// Angles of an arc, distributed nearly as W is: a mixture of even angles and even sines, in the shares that they have of
// the integral of even + swelling cosφ. The sines stop at a right angle, behind which little is left.
float last_sine(EndCircle c) { return sin(min(c.phi, 0.5 * pi)); }

float even_share(EndCircle c) {
    float even = max(c.even, 0.0) * c.phi; // below 0 where the end lies behind the centre
    return even / (even + c.swelling * last_sine(c));
}

float sample_arc(EndCircle c, float t) {
    float share = even_share(c);
    if (t < share) return t / share * c.phi;
    return asin(clamp((t - share) / (1.0 - share), 0.0, 1.0) * last_sine(c));
}

float p_arc(EndCircle c, float phi) {
    float share = even_share(c);
    return share / c.phi + (1.0 - share) * max(cos(phi), 0.0) / last_sine(c);
}
