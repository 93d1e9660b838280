// Transmittance of a ray: the product over all surfaces along it.
//
// Boxes lie in depth-first order: a ray that hits a box continues with the next one, a ray that misses it skips its subtree
// (Smits 1998, "Efficiency issues for ray tracing", section 3.1), so no stack is needed. Boxes: slabs, the far side
// widened by what rounding may take (Ize 2013, "Robust BVH Ray Traversal", section 3).
// Limit: llvmpipe ends all loops of a pixel after 65,535 turns in total. Keep in sync with BvhNode in src/shadow/bvh.hpp.
#include "interface/casters.glsl"
#include "visibility/caster_triangle.glsl"

const float far_widening = 1.00000024; // 1 + 2 ulp
const float min_direction = 1e-30; // in place of 0, whose inverse times 0 is no number

vec3 inverse_direction(vec3 d) { return 1.0 / mix(d, vec3(min_direction), equal(d, vec3(0.0))); }

vec3 transmittance(Ray ray, int light) {
    vec3 inverse = inverse_direction(ray.direction);
    int count = textureSize(bvh_nodes) / 2;
    vec3 V = vec3(1.0);
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
        if (V == vec3(0.0)) return V;
    }
    return V;
}
