// V(x, y) by depth maps from the frame's points on the emitters (--visibility map).
//
// A map names the triangle that light meets first in each texel. Of the sixteen texels around x the triangles are asked
// whether they really are between x and the point y, so that the edges of shadows are as sharp as with rays (Lecocq et
// al. 2014, "Sub-pixel shadow mapping") and no surface shadows itself. That misses what is smaller than a texel, so
// depths have a say, too: x is in the shadow where what the four texels around it show is in front of the plane of its
// triangle, by more than a texel's footprint.
#include "surface/surface.glsl"
#include "visibility/caster_triangle.glsl"
#include "visibility/kept.glsl"
#include "visibility/map_place.glsl"

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

// Whether that surface is in front of x. `emitter`: s up to which the emitter's own body reaches.
bool stands_before(int triangle, TexelRay ray, Plane receiver, float emitter, bool is_parallel, int light) {
    vec4 p0 = texelFetch(caster_triangles, 3 * triangle);
    vec3 p1 = texelFetch(caster_triangles, 3 * triangle + 1).xyz;
    vec3 p2 = texelFetch(caster_triangles, 3 * triangle + 2).xyz;
    if (p0.w >= 0.0) {
        Caster caster = caster_at(int(p0.w));
        if (caster.first_light <= light && light < caster.end_light) return false;
    }
    Plane plane = Plane(p0.xyz, cross(p1 - p0.xyz, p2 - p0.xyz));
    float s = depth_of(plane, ray);
    float s_x = depth_of(receiver, ray);
    if (!is_parallel && !(s_x > 0.0)) s_x = dot(receiver.point - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
    float margin = ray.footprint * (is_parallel ? 1.0 : s_x);
    return s < s_x - margin && (is_parallel || s > emitter);
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

// Whether depths say that x, in texel coordinates at `at`, is in the shadow.
bool is_behind(Surface x, MapPoint y, MapPlace place, float distance, int light) {
    vec2 corner = floor(place.at + 0.5);
    ivec4 triangles = triangles_around(corner, place.layer);
    Plane receiver = plane_of(x);
    bool is_parallel = y.kind == orthographic_map;
    float own_share = is_parallel ? 0.0 : max(1.0 - distance / length(y.position - x.position), 0.0);
    for (int i = 0; i < 4; ++i) {
        if (triangles[i] == x.triangle || triangles[i] < 0) return false;
        vec2 texel = corner - vec2(i == 0 || i == 3 ? 1.0 : 0.0, i < 2 ? 0.0 : 1.0);
        TexelRay through = texel_ray(y, place, texel);
        vec3 d = through.direction;
        float emitter = own_share * dot(x.position - y.origin, d) / dot(d, d);
        if (!stands_before(triangles[i], through, receiver, emitter, is_parallel, light)) return false;
    }
    return true;
}

// `distance`: from x along wi to the emitter's surface, beyond which y may lie.
float V_by_map(Surface x, MapPoint y, vec3 wi, float distance, int light) {
    MapPlace place = map_place(y, x.position);
    if (place.layer < 0) return 1.0;
    Ray ray = ray_from(x, wi, distance);
    vec2 middle = floor(place.at + 0.5) - 1.0;
    ivec4 asked = ivec4(x.triangle, -1, -1, -1); // the last ones
    for (int i = 0; i < 4; ++i) {
        ivec4 triangles = triangles_around(middle + 2.0 * vec2(i & 1, i >> 1), place.layer);
        for (int j = 0; j < 4; ++j) {
            if (any(equal(ivec4(triangles[j]), asked)) || triangles[j] < 0) continue;
            if (through_kept(ray, light, triangles[j], y.seed) == 0.0) return 0.0;
            asked = ivec4(x.triangle, triangles[j], asked.yz);
        }
    }
    return asked.y >= 0 && is_behind(x, y, place, distance, light) ? 0.0 : 1.0;
}

// Lights without extent, whose one point is where they are; of others integrator/shadowed_by_maps.glsl takes care.
float visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    if (has_extent(light)) return 1.0;
    return V_by_map(x, map_point(light, 0), wi, distance, light);
}
