// What flat emitters share: a plane with a front, met by a ray.
#include "interface/lights.glsl"

// Whether x, to which the emitter's plane is at `to_plane`, is on a side to which the emitter emits.
bool faces(Light light, vec3 to_plane) { return dot(light.direction, to_plane) < 0.0 || light.is_two_sided; }

// The coordinates (s, t) of the point q of the emitter's plane, told from the centre: q = s half_u + t half_v.
vec2 plane_coordinates(Light light, vec3 q) {
    return vec2(dot(q, light.half_u) / dot(light.half_u, light.half_u),
                dot(q, light.half_v) / dot(light.half_v, light.half_v));
}

// How far the emitter's plane is in direction wi; not positive where it is behind or alongside.
float distance_to_plane(Light light, vec3 to_plane, vec3 wi) {
    float towards = dot(light.direction, wi);
    return towards == 0.0 ? -1.0 : dot(light.direction, to_plane) / towards;
}
