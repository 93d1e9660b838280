// A2.7: the equation for matt surfaces: L_o = L_e + L_r.
#include "assignment/not_implemented.glsl"
#include "diffuse.glsl"
#include "lamps.glsl"

const int point_lamp = 0;
const int spot_lamp = 1;
const int directional_lamp = 2;

struct Lamp {
    int kind;          // point_lamp, spot_lamp or directional_lamp
    vec3 position;     // [m], of a point or a spot
    vec3 axis;         // unit: where a spot or directional light goes
    vec3 quantity;     // red, green, blue: I [cd] of a point or a spot, E_⊥ [lx] of directional light
    float cos_inner;   // of a spot
    float cos_outer;
};

// begin solution A2.7
// E of any lamp, in red, green and blue. Call E_point, E_spot and E_directional.       [lx]
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}

// L_o = L_e + L_r. E is the sum over all lamps. Call L_r.                              [cd/m²]
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e + L_r(rho, E); }
// end
