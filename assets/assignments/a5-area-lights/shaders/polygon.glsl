// A5.7 (extra): the irradiance from a rectangle, without samples.
#include "lamps.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A5.7
float edge_part(vec3 a, vec3 b, vec3 n) {
    vec3 g = cross(a, b);
    float s = length(g);
    return atan(s, dot(a, b)) * dot(g / s, n);
}

// E = L_e/2 Σ_k Θ_k (Γ_k · n) over the edges                                            [lx]
//
// v_k and v_k+1 are the unit directions to the ends of edge k, Θ_k is the angle between them [rad], and Γ_k the unit
// vector along v_k × v_k+1 or against it, so that E ≥ 0. The lamp lies above the horizon, x before the lamp.
float E_rectangle(Rectangle r, float L_e, vec3 x, vec3 n) {
    vec3 a = normalize(r.corner - x);
    vec3 b = normalize(r.corner + r.edge_v - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x);
    vec3 d = normalize(r.corner + r.edge_u - x);
    return 0.5 * L_e * abs(edge_part(a, b, n) + edge_part(b, c, n) + edge_part(c, d, n) + edge_part(d, a, n));
}
// end
