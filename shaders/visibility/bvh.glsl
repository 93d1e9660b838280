// The product of what all surfaces along a ray let through.
//
// Boxes lie in depth-first order: who meets a box goes on with the next one, who misses it skips its whole subtree
// (Smits 1998, "Efficiency issues for ray tracing", section 3.1), so no stack is needed. Boxes: slabs, the far side
// widened by what rounding may take (Ize 2013, "Robust BVH Ray Traversal", section 3). Triangles: the signs of the
// ray's volumes with the edges, which two triangles that share an edge compute alike, so no ray slips between them.
// Limit: llvmpipe ends all loops of a pixel after 65,535 turns in total. Mirror: BvhNode in src/shadow/bvh.hpp.
#include "interface/casters.glsl"
#include "visibility/alpha.glsl"
#include "visibility/origin.glsl"

const float far_widening = 1.00000024; // 1 + 2 ulp
const float smallest_direction = 1e-30; // in place of 0, whose inverse times 0 is no number

vec3 inverse_direction(vec3 d) { return 1.0 / mix(d, vec3(smallest_direction), equal(d, vec3(0.0))); }

// t, and the weights of the three corners; t < 0 where the ray does not meet the triangle.
vec4 meeting(Ray ray, vec3 p0, vec3 p1, vec3 p2) {
    precise vec3 a = p0 - ray.origin;
    precise vec3 b = p1 - ray.origin;
    precise vec3 c = p2 - ray.origin;
    precise vec3 across_bc = cross(b - c, b + c);
    precise vec3 across_ca = cross(c - a, c + a);
    precise vec3 across_ab = cross(a - b, a + b);
    precise vec3 volumes =
        vec3(dot(across_bc, ray.direction), dot(across_ca, ray.direction), dot(across_ab, ray.direction));
    float low = min(volumes.x, min(volumes.y, volumes.z));
    float high = max(volumes.x, max(volumes.y, volumes.z));
    if (low < 0.0 && high > 0.0) return vec4(-1.0);
    vec3 n = cross(p1 - p0, p2 - p0);
    float towards = dot(ray.direction, n);
    float sum = volumes.x + volumes.y + volumes.z;
    if (towards == 0.0 || sum == 0.0) return vec4(-1.0);
    return vec4(dot(a, n) / towards, volumes / sum);
}

float through_triangle(Ray ray, int light, int place) {
    vec4 p0 = texelFetch(caster_triangles, 3 * place);
    vec4 p1 = texelFetch(caster_triangles, 3 * place + 1);
    vec4 p2 = texelFetch(caster_triangles, 3 * place + 2);
    vec4 at = meeting(ray, p0.xyz, p1.xyz, p2.xyz);
    if (at.x < 0.0 || at.x > ray.end) return 1.0;
    if (p0.w < 0.0) return 0.0;
    Caster caster = caster_at(int(p0.w));
    bool is_own = caster.first_light <= light && light < caster.end_light;
    if (is_own && at.x >= ray.end * (1.0 - caster.own_share)) return 1.0;
    return transmittance_at(caster, int(p1.w), at.yzw);
}

float transmittance(Ray ray, int light) {
    vec3 inverse = inverse_direction(ray.direction);
    int count = textureSize(bvh_nodes) / 2;
    float V = 1.0;
    for (int node = 0; node < count;) {
        ivec4 low = texelFetch(bvh_nodes, 2 * node);      // w: the node to skip to
        ivec4 high = texelFetch(bvh_nodes, 2 * node + 1); // w: 0, or of a leaf 8 * first place + count
        vec3 t_low = (intBitsToFloat(low.xyz) - ray.origin) * inverse;
        vec3 t_high = (intBitsToFloat(high.xyz) - ray.origin) * inverse;
        vec3 enter = min(t_low, t_high);
        vec3 leave = max(t_low, t_high);
        bool is_met = max(max(enter.x, enter.y), max(enter.z, 0.0))
                      <= min(min(leave.x, leave.y), min(leave.z, ray.end)) * far_widening;
        node = is_met && high.w == 0 ? node + 1 : low.w;
        if (!is_met || high.w == 0) continue;
        for (int i = 0; i < (high.w & 7); ++i) V *= through_triangle(ray, light, (high.w >> 3) + i);
        if (V == 0.0) return 0.0;
    }
    return V;
}
