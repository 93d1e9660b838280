// One triangle of the shadow casters and a ray that may meet it.
//
// The signs of the ray's volumes with the edges decide, which two triangles that share an edge compute alike, so no ray
// slips between them.
#include "interface/features.glsl"
#include "interface/lights.glsl"
#include "visibility/alpha.glsl"
#include "visibility/origin.glsl"

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

// The share of the light that goes through, where the ray meets the triangle.
vec3 through_triangle(Ray ray, int light, int place) {
    vec4 p0 = texelFetch(caster_triangles, 3 * place);
    vec4 p1 = texelFetch(caster_triangles, 3 * place + 1);
    vec4 p2 = texelFetch(caster_triangles, 3 * place + 2);
    vec4 at = meeting(ray, p0.xyz, p1.xyz, p2.xyz);
    if (at.x < 0.0 || at.x > ray.end) return vec3(1.0);
    if (p0.w < 0.0) return vec3(0.0);
    Caster caster = caster_at(int(p0.w));
    bool is_own = caster.first_light <= light && light < caster.end_light;
    if (is_own && at.x >= ray.end * (1.0 - caster.own_share)) return vec3(1.0);
    bool is_front = caster.front * dot(cross(p1.xyz - p0.xyz, p2.xyz - p0.xyz), ray.direction) < 0.0;
    if (is_front && passes_back_faces(light)) return vec3(1.0); // the light would come from behind
    if (!has_transparent_casters) return vec3(0.0);
    return vec3(transmittance_at(caster, int(p1.w), at.yzw));
}
