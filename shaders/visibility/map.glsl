// V(x, y) by depth maps from the frame's points on the emitters (--visibility map).
//
// A map names the triangle that light meets first in each texel. Of the sixteen texels around x the triangles are asked
// whether they really are between x and the point y, so that the edges of shadows are as sharp as with rays (Lecocq et
// al. 2014, "Sub-pixel shadow mapping") and no surface shadows itself. That misses what is smaller than a texel, so
// depths have a say, too: x is in the shadow where all that the four texels around it show is in front of the plane of its
// triangle, or more than half of it, weighed bilinearly, is so and made of small triangles.
#include "surface/surface.glsl"
#include "visibility/caster_triangle.glsl"
#include "visibility/kept.glsl"
#include "visibility/map_place.glsl"

const float few_texels = 4.0; // the area up to which a triangle is small: larger ones do not slip between sixteen texels
const float margin = 0.25; // of a texel: by so much rises the next texel of a hollow whose radius is two texels

struct Plane {
    vec3 point;
    vec3 normal; // of any length
};

// The plane in which x lies: its triangle's.
Plane plane_of(Surface x) {
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

// Where that surface is, as seen from x. `emitter`: s up to which the emitter's own body reaches.
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

// What the triangle lets through in this frame: nothing or all.
float through_kept(Ray ray, int light, int triangle, uint map_seed) {
    float T = through_triangle(ray, light, triangle);
    if (T == 0.0 || T == 1.0) return T;
    return is_kept(triangle, map_seed, 1.0 - T) ? 0.0 : 1.0;
}

// The triangles of the four texels around the corner of texels at `at`: upper left, upper right, lower right, lower left.
ivec4 triangles_around(vec2 at, int layer) {
    return textureGather(map_triangles, vec3(at / float(textureSize(map_triangles, 0).x), float(layer)));
}

// What the depths of the four texels around the corner of texels at `corner` say of x: 0 where it is in the shadow.
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

// Up to eight triangles, each once; the latest first.
struct Candidates {
    ivec4 first;
    ivec4 second;
    int count;
};

void note(inout Candidates c, int triangle, int own) {
    bool is_known = triangle == own || any(equal(ivec4(triangle), c.first)) || any(equal(ivec4(triangle), c.second));
    c.second = is_known ? c.second : ivec4(c.first.w, c.second.xyz);
    c.first = is_known ? c.first : ivec4(triangle, c.first.xyz);
    c.count = is_known ? c.count : min(c.count + 1, 8);
}

// `distance`: from x along wi to the emitter's surface, beyond which y may lie. Drivers for CPUs do not jump over what a
// condition leaves out, but they end loops: so a triangle is a turn of a loop, and what depths say is another.
float V_by_map(Surface x, MapPoint y, vec3 wi, float distance, int light) {
    MapPlace place = map_place(y, x.position);
    vec2 corner = floor(place.at + 0.5);
    Candidates c = Candidates(ivec4(-1), ivec4(-1), 0); // -1, no triangle, is known
    for (int i = 0; i < 4; ++i) {
        ivec4 triangles = triangles_around(corner + 2.0 * vec2(i & 1, i >> 1) - 1.0, max(place.layer, 0));
        for (int j = 0; j < 4; ++j) note(c, triangles[j], x.triangle);
    }
    Ray ray = ray_from(x, wi, distance);
    float V = 1.0;
    int turns = place.layer < 0 ? 0 : c.count;
    for (int i = 0; i < turns && V > 0.0; ++i) {
        V = through_kept(ray, light, c.first.x, y.seed);
        c.first = ivec4(c.first.yzw, c.second.x);
        c.second = c.second.yzwx;
    }
    for (bool is_open = turns > 0 && V > 0.0; is_open; is_open = false)
        V = V_by_depths(x, y, place, corner, distance, light);
    return V;
}

// Lights without extent, whose one point is where they are; of others integrator/shadowed_by_maps.glsl takes care.
float visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    if (has_extent(light)) return 1.0;
    return V_by_map(x, map_point(light, 0), wi, distance, light);
}
