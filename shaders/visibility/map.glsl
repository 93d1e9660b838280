// V(x, y) by depth maps from the frame's points on the emitters (--visibility map).
//
// A map names the triangle that light meets first in each texel. The triangles of the sixteen texels around x are tested:
// those that really are between x and the point y count, so that the edges of shadows are as sharp as with rays (Lecocq et
// al. 2014, "Sub-pixel shadow mapping") and no surface shadows itself. That misses what is smaller than a texel, so
// depths are compared, too (map_depths.glsl).
#include "surface/surface.glsl"
#include "visibility/bvh.glsl"
#include "visibility/caster_triangle.glsl"
#include "visibility/stochastic_alpha.glsl"
#include "visibility/map_depths.glsl"

// Transmittance of the triangle in this frame: 0 or 1.
float through_kept(Ray ray, int light, int triangle, uint map_seed) {
    float T = through_triangle(ray, light, triangle).x;
    if (T == 0.0 || T == 1.0) return T;
    return is_kept(triangle, map_seed, 1.0 - T) ? 0.0 : 1.0;
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
vec3 V_by_map(Surface x, MapPoint y, vec3 wi, float distance, int light) {
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
    // Glass is in no map: a tree of it alone tells its colour.
    return has_tinted_casters && V > 0.0 ? transmittance(ray, light) : vec3(V);
}

// Lights without extent, whose one point is where they are; of others integrator/shadowed_by_maps.glsl takes care.
vec3 visibility(Surface x, vec3 wi, float distance, int light, int ray) {
    if (has_extent(light)) return vec3(1.0);
    return V_by_map(x, map_point(light, 0), wi, distance, light);
}
