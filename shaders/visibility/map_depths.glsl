// Shadow test by depths, for triangles smaller than a depth map's texels (visibility/map.glsl): x is in shadow where
// all that the four texels around it show is in front of the plane of its triangle, or more than half of it, weighed
// bilinearly, is so and made of small triangles.
#include "interface/casters.glsl"
#include "surface/surface.glsl"
#include "visibility/map_place.glsl"

const float few_texels = 4.0; // the area up to which a triangle is small: larger ones do not slip between sixteen texels
const float margin = 0.25; // of a texel: by so much rises the next texel of a hollow whose radius is two texels

struct Plane {
    vec3 point;
    vec3 normal; // of any length
};

// The plane in which x lies: its triangle's; on a line or point the shading normal's.
Plane plane_of(Surface x) {
    if (x.triangle < 0) return Plane(x.position, x.n);
    vec3 a = texelFetch(caster_triangles, 3 * x.triangle).xyz;
    vec3 b = texelFetch(caster_triangles, 3 * x.triangle + 1).xyz;
    vec3 c = texelFetch(caster_triangles, 3 * x.triangle + 2).xyz;
    return Plane(x.position, cross(b - a, c - a));
}

// s where the texel's ray meets the plane; negative where it does not.
float depth_of(Plane plane, TexelRay ray) {
    float towards = dot(plane.normal, ray.direction);
    return towards == 0.0 ? -1.0 : dot(plane.normal, plane.point - ray.origin) / towards;
}

const int behind = 0;
const int before = 1;
const int small_before = 2;

// Position of that surface, as seen from x. `emitter`: s up to which the emitter's own body reaches.
int standing(int triangle, TexelRay ray, Plane receiver, float emitter, bool is_parallel, int light) {
    vec4 p0 = texelFetch(caster_triangles, 3 * triangle);
    vec3 p1 = texelFetch(caster_triangles, 3 * triangle + 1).xyz;
    vec3 p2 = texelFetch(caster_triangles, 3 * triangle + 2).xyz;
    if (p0.w >= 0.0) {
        Caster caster = caster_at(int(p0.w));
        if (caster.first_light <= light && light < caster.end_light) return behind;
    }
    Plane plane = Plane(p0.xyz, cross(p1 - p0.xyz, p2 - p0.xyz));
    float s = depth_of(plane, ray);
    float s_x = depth_of(receiver, ray);
    if (!is_parallel && !(s_x > 0.0)) s_x = dot(receiver.point - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
    float texel = ray.footprint * (is_parallel ? 1.0 : s_x);
    if (!(s < s_x - margin * texel) || (!is_parallel && s <= emitter)) return behind;
    bool is_small = abs(dot(plane.normal, ray.direction)) < 2.0 * few_texels * texel * texel;
    return is_small ? small_before : before;
}

// The triangles of the four texels around the corner of texels at `at`: upper left, upper right, lower right, lower left.
ivec4 triangles_around(vec2 at, int layer) {
    return textureGather(map_triangles, vec3(at / float(textureSize(map_triangles, 0).x), float(layer)));
}

// V of x by the depths of the four texels around the corner of texels at `corner`: 0 in shadow.
float V_by_depths(Surface x, MapPoint y, MapPlace place, vec2 corner, float distance, int light) {
    ivec4 triangles = triangles_around(corner, place.layer);
    Plane receiver = plane_of(x);
    bool is_parallel = y.kind == orthographic_map;
    float own_share = is_parallel ? 0.0 : max(1.0 - distance / length(y.position - x.position), 0.0);
    int in_front = 0;
    float votes = 0.0;
    for (int i = 0; i < 4; ++i) {
        if (triangles[i] == x.triangle || triangles[i] < 0) continue;
        vec2 texel = corner - vec2(i == 0 || i == 3 ? 1.0 : 0.0, i < 2 ? 0.0 : 1.0);
        TexelRay through = texel_ray(y, place, texel);
        vec3 d = through.direction;
        float emitter = own_share * dot(x.position - y.origin, d) / dot(d, d);
        int stands = standing(triangles[i], through, receiver, emitter, is_parallel, light);
        vec2 weight = 1.0 - abs(place.at - texel - 0.5);
        in_front += stands == behind ? 0 : 1;
        votes += stands == small_before ? weight.x * weight.y : 0.0;
    }
    return in_front == 4 || votes > 0.5 ? 0.0 : 1.0;
}
