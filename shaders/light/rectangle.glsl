// A rectangle of radiance L_e, sampled uniformly over the solid angle Ω in which it is seen.
//
//   p(wi) = 1 / Ω                                              [1/sr]
//
// Ureña, Fajardo & King 2013, sections 3 and 4: in a frame with x and y along the edges, the rectangle lies at height
// z < 0 over [x0, x1] × [y0, y1]; Ω is the spherical excess of the angles between the planes of its edges. The angles
// come from atan(|z| r, x y), which is exact where the arc cosine of the paper cancels. Below Ω = 2e-3 sr, where the
// excess itself cancels in 32 bits, points are uniform over the area A: p(wi) = d² / (A cosθ_y). u in [0, 1)².
#include "base/constants.glsl"
#include "light/emission_map.glsl"
#include "light/flat.glsl"
#include "light/light_sample.glsl"

struct SphericalRectangle {
    vec2 low;         // (x0, y0) [m]
    vec2 high;        // (x1, y1) [m]
    float z;          // < 0 [m]
    vec4 angles;      // between the edges' planes at (x1, y0), (x1, y1), (x0, y1), (x0, y0)
    float solid_angle;
};

const float min_solid_angle = 2e-3; // [sr]

float angle_at(float z, float x, float y, float handedness) {
    return atan(-z * sqrt(x * x + y * y + z * z), handedness * x * y);
}

SphericalRectangle spherical_rectangle(Light light, vec3 to_center) {
    float half_width = length(light.half_u);
    float half_height = length(light.half_v);
    vec2 c = vec2(dot(to_center, light.half_u) / half_width, dot(to_center, light.half_v) / half_height);
    SphericalRectangle r;
    r.low = c - vec2(half_width, half_height);
    r.high = c + vec2(half_width, half_height);
    r.z = -abs(dot(to_center, light.direction));
    r.angles = vec4(angle_at(r.z, r.high.x, r.low.y, 1.0), angle_at(r.z, r.high.x, r.high.y, -1.0),
                    angle_at(r.z, r.low.x, r.high.y, 1.0), angle_at(r.z, r.low.x, r.low.y, -1.0));
    r.solid_angle = r.angles.x + r.angles.y + r.angles.z + r.angles.w - 2.0 * pi;
    return r;
}

// The point's place in the rectangle's frame: (x, y).
vec2 sample_spherical_rectangle(SphericalRectangle r, vec2 u) {
    float b0 = -r.low.y * inversesqrt(r.z * r.z + r.low.y * r.low.y);
    float b1 = r.high.y * inversesqrt(r.z * r.z + r.high.y * r.high.y);
    float turn = u.x * r.solid_angle + 2.0 * pi - r.angles.z - r.angles.w;
    vec2 f = vec2(cos(turn) * b0 - b1, sin(turn) * b0);
    float cu = clamp((f.x > 0.0 ? 1.0 : -1.0) * sin(turn) * inversesqrt(dot(f, f)), -1.0, 1.0);
    float x = clamp(-cu * r.z * inversesqrt(max(1.0 - cu * cu, 1e-12)), r.low.x, r.high.x); // 1e-12: cu = ±1, clamped next
    float d2 = x * x + r.z * r.z;
    float h0 = r.low.y * inversesqrt(d2 + r.low.y * r.low.y);
    float h1 = r.high.y * inversesqrt(d2 + r.high.y * r.high.y);
    float h = mix(h0, h1, u.y);
    return vec2(x, clamp(h * sqrt(d2 / max(1.0 - h * h, 1e-12)), r.low.y, r.high.y));
}

float p_rectangle(Light light, SphericalRectangle r, float distance) {
    if (r.solid_angle >= min_solid_angle) return 1.0 / r.solid_angle;
    vec2 edges = r.high - r.low;
    return distance * distance * distance / (edges.x * edges.y * -r.z); // cosθ_y = |z| / d
}

LightSample sample_rectangle(Light light, vec3 x, vec2 u) {
    vec3 to_center = light.position - x;
    if (!faces(light, x, to_center)) return no_light;
    SphericalRectangle r = spherical_rectangle(light, to_center);
    vec2 place = r.solid_angle >= min_solid_angle ? sample_spherical_rectangle(r, u) : mix(r.low, r.high, u);
    vec2 st = 2.0 * (place - r.low) / (r.high - r.low) - 1.0;
    vec3 to_light = to_center + st.x * light.half_u + st.y * light.half_v;
    float d = length(to_light);
    return light_sample(to_light / d, d, light.quantity * emission_at(light, st), p_rectangle(light, r, d));
}

// The rectangle as a ray from x meets it.
LightSample rectangle_along(Light light, vec3 x, vec3 wi) {
    vec3 to_center = light.position - x;
    float d = distance_to_plane(light, to_center, wi);
    vec2 st = plane_coordinates(light, d * wi - to_center);
    if (!(d > 0.0 && abs(st.x) <= 1.0 && abs(st.y) <= 1.0) || !faces(light, x, to_center)) return no_light;
    float p = p_rectangle(light, spherical_rectangle(light, to_center), d);
    return light_sample(wi, d, light.quantity * emission_at(light, st), p);
}
