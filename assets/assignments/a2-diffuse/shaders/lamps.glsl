// A2.1 to A2.3: what a lamp sends to a point. x is a point of a surface [m], n its unit normal; y is where the lamp is [m].
#include "assignment/not_implemented.glsl"
#include "base/constants.glsl"

// begin solution A2.1
// E = I max(0, cosθ_i) / r²: irradiance by a point of intensity I [cd]                  [lx]
//
// r is the distance from x to y, θ_i the angle between n and the direction to the lamp.
float E_point(vec3 x, vec3 n, vec3 y, float intensity) {
    vec3 to_lamp = y - x;
    float r2 = dot(to_lamp, to_lamp);
    return intensity * max(0.0, dot(n, to_lamp * inversesqrt(r2))) / r2;
}
// end

// begin solution A2.2
// I(w) = I s², s = (cosθ - cos_outer) / (cos_inner - cos_outer), kept within 0 and 1   [cd]
//
// θ is the angle between the axis of the spot and w. Both are unit and leave the lamp.
float spot_intensity(float intensity, vec3 axis, vec3 w, float cos_inner, float cos_outer) {
    float s = clamp((dot(axis, w) - cos_outer) / (cos_inner - cos_outer), 0.0, 1.0);
    return intensity * s * s;
}

// E = I(w) max(0, cosθ_i) / r²: irradiance by a spot. Call spot_intensity and E_point.  [lx]
float E_spot(vec3 x, vec3 n, vec3 y, float intensity, vec3 axis, float cos_inner, float cos_outer) {
    vec3 w = normalize(x - y);
    return E_point(x, n, y, spot_intensity(intensity, axis, w, cos_inner, cos_outer));
}
// end

// begin solution A2.3
// E = E_⊥ max(0, cosθ_i): irradiance by light of one direction                         [lx]
//
// direction is unit and says where the light goes. E_perpendicular is what a surface gets that faces it [lx].
float E_directional(vec3 n, vec3 direction, float E_perpendicular) {
    return E_perpendicular * max(0.0, -dot(n, direction));
}
// end
