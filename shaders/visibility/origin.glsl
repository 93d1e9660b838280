// Origin and end of a shadow ray: the points origin + t direction for 0 <= t <= end.
//
// x is put into its triangle's plane, where interpolation left it off by rounding, and moved along the geometric
// normal to the side of wi by 2^-17 (64 units in the last place) of the triangle's largest coordinate, to which all
// rounding is proportional. The idea of an offset in such units is Wächter & Binder's (2019, "A Fast and Robust
// Method for Avoiding Self-Intersection"), who take those of the point itself. A finite ray ends 2^-15 of its length
// before the emitter's point, so that an emitter in the plane of another surface is not shadowed by it.
// Keep in sync with src/shadow/occlusion.cpp.
#include "interface/casters.glsl"
#include "surface/surface.glsl"

struct Ray {
    vec3 origin;
    vec3 direction; // not unit where the light has a place: t = 1 is the emitter's point
    float end;
};

const float infinitely_far_away = 1e30;
const float offset_share = 1.0 / 131072.0;
const float last_share = 1.0 - 1.0 / 32768.0;

float largest_coordinate(vec3 v) { return max(abs(v.x), max(abs(v.y), abs(v.z))); }

// Lines and points have no plane: the ray begins as far off, along wi.
Ray ray_from_line(vec3 x, vec3 wi, float distance) {
    vec3 origin = x + offset_share * largest_coordinate(x) * wi;
    if (distance >= infinitely_far_away) return Ray(origin, wi, infinitely_far_away);
    return Ray(origin, x + distance * wi - origin, last_share);
}

Ray ray_from(Surface x, vec3 wi, float distance) {
    if (x.triangle < 0) return ray_from_line(x.position, wi, distance);
    int place = texelFetch(triangle_places, x.triangle).r;
    if (place < 0) return Ray(x.position, wi, 0.0);
    vec3 a = texelFetch(caster_triangles, 3 * place).xyz;
    vec3 b = texelFetch(caster_triangles, 3 * place + 1).xyz;
    vec3 c = texelFetch(caster_triangles, 3 * place + 2).xyz;
    vec3 n = cross(b - a, c - a);
    float n_length = length(n);
    n = n_length > 0.0 ? n / n_length : vec3(0.0);
    float reach = max(largest_coordinate(a), max(largest_coordinate(b), largest_coordinate(c)));
    float side = dot(n, wi) < 0.0 ? -1.0 : 1.0;
    vec3 origin = x.position + (side * offset_share * reach - dot(x.position - a, n)) * n;
    if (distance >= infinitely_far_away) return Ray(origin, wi, infinitely_far_away);
    return Ray(origin, x.position + distance * wi - origin, last_share);
}
