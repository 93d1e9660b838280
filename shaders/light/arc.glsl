// A piece of an emitter's outline as x sees it: an arc of the cone
//
//   p(φ) = γ z' + α cosφ x' + β sinφ y'        α >= β >= 0, γ >= 0; x', y', z' a right-handed frame
//
// A disk, an ellipse and a sphere are seen through such a cone, and linear maps take cones to cones. A straight
// piece is one too: α = β = 1, γ = 0. Arcs are walked in the angle ψ with tanψ = √(B/A) tanφ, A = γ² + α²,
// B = γ² + β², in which |p|² dψ = √(AB) dφ: the unit direction b = p/|p| and its turn b×b' need no division by |p|.
//
// The projection of the irradiance vector on the axis z, n·Σ∫ p×p'/|p|² / 2 (Lambert 1760 for straight pieces), is
// elementary in φ for cones as well:
//
//   ∫ p×p'/|p|² dφ = -γβ x' artanh(k sinφ)/(A k) + γα y' arctan(m cosφ)/(B m) + αβ z' ψ/√(AB)
//   k² = (α² - β²)/A,   m² = (α² - β²)/B
#include "base/angle.glsl"
#include "interface/features.glsl"

// Where all emitters are flat, all that cones take is left out.
const bool has_cones = has_disk_lights || has_sphere_lights || has_tube_lights || has_sun_disks;

struct Arc {
    mat3 axes;   // x', y', z'
    vec3 size;   // α, β, γ
    float from;  // ψ [rad]; the arc goes counter-clockwise as seen from x ...
    float to;    // ... to here, at most 2π further; nothing is left where to <= from
};

const Arc no_arc = Arc(mat3(1.0), vec3(1.0, 1.0, 0.0), 0.0, 0.0);

// (√A, √B)
vec2 arc_radii(Arc arc) { return sqrt(arc.size.z * arc.size.z + arc.size.xy * arc.size.xy); }

// ψ of a direction on the cone.
float arc_angle(Arc arc, vec3 p) {
    vec2 radii = arc_radii(arc);
    vec2 along = vec2(dot(p, arc.axes[0]), dot(p, arc.axes[1])); // (α cosφ, β sinφ) up to a factor
    return angle_of(radii * along * arc.size.yx);
}

// b and b×b' at ψ.
void arc_at(Arc arc, float psi, out vec3 b, out vec3 turn) {
    if (!has_cones) {
        b = cos(psi) * arc.axes[0] + sin(psi) * arc.axes[1];
        turn = arc.axes[2];
        return;
    }
    vec2 radii = arc_radii(arc);
    vec2 e = radii.yx * vec2(cos(psi), sin(psi)); // (cosφ, sinφ) up to its length
    float l = length(e);
    float scale = 1.0 / (radii.x * radii.y);
    b = arc.axes * vec3(arc.size.xy * e, arc.size.z * l) * scale;
    turn = arc.axes * vec3(-arc.size.z * arc.size.yx * e / l, arc.size.x * arc.size.y) * scale;
}

vec3 arc_direction(Arc arc, float psi) {
    vec3 b, turn;
    arc_at(arc, psi, b, turn);
    return b;
}

// artanh(x) / x with 1 - x² given, which cancels where x is close to 1.
float artanh_over(float x, float rest) {
    if (abs(x) > 0.3) return 0.5 * log((1.0 + abs(x)) * (1.0 + abs(x)) / rest) / abs(x);
    float x2 = x * x;
    return 1.0 + x2 * (1.0 / 3.0 + x2 * (1.0 / 5.0 + x2 * (1.0 / 7.0 + x2 * (1.0 / 9.0 + x2 / 11.0))));
}

float arctan_over(float x) { return abs(x) < 1e-3 ? 1.0 - x * x / 3.0 : angle_of(vec2(1.0, x)) / x; }

// The z component of the integral up to ψ.
float arc_primitive(Arc arc, float psi) {
    vec2 radii = arc_radii(arc);
    vec2 e = radii.yx * vec2(cos(psi), sin(psi));
    vec2 trig = e / length(e); // (cosφ, sinφ)
    vec2 squares = radii * radii;
    float difference = (arc.size.x - arc.size.y) * (arc.size.x + arc.size.y);
    float ks = sqrt(difference / squares.x) * trig.y;
    float mc = sqrt(difference / squares.y) * trig.x;
    float rest = dot(squares / squares.x, trig * trig); // 1 - (k sinφ)²
    return -arc.size.z * arc.size.y * arc.axes[0].z * trig.y * artanh_over(ks, rest) / squares.x
           + arc.size.z * arc.size.x * arc.axes[1].z * trig.x * arctan_over(mc) / squares.y
           + arc.size.x * arc.size.y * arc.axes[2].z * psi / (radii.x * radii.y);
}

// The z component of ∫ b×b' dψ over the arc.
float arc_projection(Arc arc) {
    if (!has_cones || arc.size.z == 0.0) return arc.axes[2].z * (arc.to - arc.from);
    return arc_primitive(arc, arc.to) - arc_primitive(arc, arc.from);
}
