// The plane of a flat emitter: its front, and its intersection with a ray.
#include "interface/lights.glsl"

// Returns whether a flat emitter shines on x. `front` is the normal of its front, of any length; `to_plane` leads from x to a point of
// its plane. An emitter sends nothing to points of its own plane. Rounding leaves these off the plane by some units in the last
// place of their coordinates, so points nearer than 2^-18 (32 units) of those count as on it.
bool shines_on(vec3 front, vec3 x, vec3 to_plane, bool is_two_sided) {
    vec3 size = abs(x) + abs(to_plane);
    float rounding = 3.8e-6 * max(size.x, max(size.y, size.z)) * length(front);
    float height = -dot(front, to_plane);
    return (is_two_sided ? abs(height) : height) > rounding;
}

bool faces(Light light, vec3 x, vec3 to_plane) { return shines_on(light.direction, x, to_plane, light.is_two_sided); }

// The coordinates (s, t) of the point q of the emitter's plane, told from the centre: q = s half_u + t half_v.
vec2 plane_coordinates(Light light, vec3 q) {
    return vec2(dot(q, light.half_u) / dot(light.half_u, light.half_u),
                dot(q, light.half_v) / dot(light.half_v, light.half_v));
}

// Distance to the emitter's plane along wi; not positive if it is behind x or parallel to wi.
float distance_to_plane(Light light, vec3 to_plane, vec3 wi) {
    float towards = dot(light.direction, wi);
    return towards == 0.0 ? -1.0 : dot(light.direction, to_plane) / towards;
}
