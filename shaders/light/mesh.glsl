// Emissive triangles: one of n is chosen by its power, then a point of it.
//
//   p(wi) = P_i / Ω_i                 where triangle i is seen large      [1/sr]
//   p(wi) = P_i d² / (A_i cosθ_y)     where it is seen small
//
// Choice: an alias table (Vose 1991), whose cost does not depend on n. The first density is that of triangle.glsl.
// Limit: a direction of the BRDF's choice does not find them (that takes a ray cast), so glossy surfaces under meshes
// are noisier than under other emitters. u.x serves twice; 2^24 / n strata are left for the point.
#include "light/emission_map.glsl"
#include "light/flat.glsl"
#include "light/light_sample.glsl"
#include "light/triangle.glsl"

const int texels_per_triangle = 5;
const float large_solid_angle = 0.01; // [sr]; below, the density over the area varies by a few percent only

// Chooses a triangle and rescales u, so that it can choose a point.
int choose_triangle(Light light, inout vec2 u) {
    float slot = u.x * float(light.count);
    int i = min(int(slot), light.count - 1);
    float within = slot - float(i);
    float keep = texelFetch(light_table, light.data + texels_per_triangle * i).w;
    bool stays = within < keep;
    u.x = clamp(stays ? within / keep : (within - keep) / (1.0 - keep), 0.0, 1.0);
    return stays ? i : int(texelFetch(light_table, light.data + texels_per_triangle * i + 1).w);
}

// Uniform over the area: barycentric weights of the second and third corner (Turk 1990).
vec2 sample_area(vec2 u) {
    float root = sqrt(u.x);
    return vec2(root * (1.0 - u.y), root * u.y);
}

LightSample sample_mesh(Light light, vec3 x, vec2 u) {
    int first = light.data + texels_per_triangle * choose_triangle(light, u);
    vec4 third = texelFetch(light_table, first + 2);
    vec3 a = texelFetch(light_table, first).xyz - x;
    vec3 ab = texelFetch(light_table, first + 1).xyz - x - a;
    vec3 ac = third.xyz - x - a;
    vec3 normal = cross(ab, ac); // 2 A long
    float height = dot(a, normal);
    if (!shines_on(normal, x, a, light.is_two_sided)) return no_light;

    float solid_angle = triangle_solid_angle(a, a + ab, a + ac, normal);
    vec2 barycentric = sample_area(u);
    if (solid_angle > large_solid_angle) {
        vec3 w = sample_spherical_triangle(a, a + ab, a + ac, solid_angle, u);
        vec3 q = height / dot(w, normal) * w - a;
        barycentric = vec2(dot(cross(q, ac), normal), dot(cross(ab, q), normal)) / dot(normal, normal);
    }
    vec3 to_light = a + barycentric.x * ab + barycentric.y * ac;
    float d2 = dot(to_light, to_light);
    float d = sqrt(d2);
    float p = third.w * (solid_angle > large_solid_angle ? 1.0 / solid_angle : 2.0 * d2 * d / abs(height));
    vec3 L_e = light.quantity;
    if (has_emission_maps && light.map >= 0) {
        vec4 uv_ab = texelFetch(light_table, first + 3);
        vec2 uv_c = texelFetch(light_table, first + 4).xy;
        L_e *= emission_map(light.map, uv_ab.xy + barycentric.x * (uv_ab.zw - uv_ab.xy) + barycentric.y * (uv_c - uv_ab.xy));
    }
    LightSample s = light_sample(to_light / d, d, L_e, p);
    s.p = 0.0; // only this way finds it
    return s;
}
