// Transmittance of a glass triangle for shadows: its material and its textures. Keep in sync with
// src/shadow/transparency.cpp and src/render/visibility/gpu_casters.cpp. Limit: specular textures and clear-coat textures are left out.
#include "surface/glass.glsl"
#include "visibility/alpha.glsl"

struct GlassMap {
    int first;  // texel
    ivec2 size; // 0: no map
    int wrap_u; // scene::Wrap
    int wrap_v;
};

GlassMap glass_map(int texel) {
    vec4 t = texelFetch(caster_data, texel);
    int wraps = int(t.w); // wrap_u + 4 wrap_v
    return GlassMap(int(t.x), ivec2(t.yz), wraps & 3, wraps >> 2);
}

// Plane `plane` of the map at uv; 1 without a map.
float glass_value(GlassMap map, int plane, vec2 uv) {
    if (map.size.x == 0) return 1.0;
    return map_value(map.first + plane * map.size.x * map.size.y, map.size, map.wrap_u, map.wrap_v, uv);
}

// `glass`: texel of its record; `corners`: texel of the triangle's corners, three texels each; `weights`: of the corners.
// n: along the triangle's normal, of any length; w: the ray's direction, of any length.
vec3 through_glass(Caster caster, int glass, int corners, vec3 weights, vec3 n, vec3 w) {
    vec4 sums[3];
    for (int i = 0; i < 3; ++i)
        sums[i] = weights.x * texelFetch(caster_data, corners + i) + weights.y * texelFetch(caster_data, corners + 3 + i)
                  + weights.z * texelFetch(caster_data, corners + 6 + i);
    vec4 factors = texelFetch(caster_data, glass);    // transmission, metallic, F0, specular
    vec4 depth = texelFetch(caster_data, glass + 1);  // σ d; w: clearcoat
    vec4 sides = texelFetch(caster_data, glass + 2);  // x: which side is the front; y: whether it is a closed body
    GlassMap base = glass_map(glass + 3);
    vec2 uv = sums[0].xy;
    vec4 color = sums[2] * vec4(glass_value(base, 0, uv), glass_value(base, 1, uv), glass_value(base, 2, uv),
                                glass_value(base, 3, uv));
    float t = factors.x * glass_value(glass_map(glass + 4), 0, sums[0].zw);
    float thickness = glass_value(glass_map(glass + 5), 0, sums[1].xy);
    float metallic = factors.y * glass_value(glass_map(glass + 6), 0, sums[1].zw);
    float towards = dot(n, w);
    bool leaves_body = sides.y != 0.0 && towards * sides.x > 0.0;
    vec3 optical_depth = leaves_body ? vec3(0.0) : depth.xyz * thickness;
    Glass x = Glass((1.0 - metallic) * t * color.rgb, factors.z, factors.w, depth.w, optical_depth);
    vec3 T = straight_transmittance(x, abs(towards) * inversesqrt(dot(n, n) * dot(w, w)));
    if (caster.alpha_mode == mask_mode) return color.a < caster.alpha_cutoff ? vec3(1.0) : T;
    if (caster.alpha_mode == blend_mode) return mix(vec3(1.0), T, clamp(color.a, 0.0, 1.0));
    return T;
}
