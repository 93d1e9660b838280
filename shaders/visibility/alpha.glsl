// Transmittance of a triangle that is masked, blended or glass. Keep in sync with src/shadow/transparency.cpp and casters.cpp.
#include "base/texel_wrap.glsl"
#include "interface/casters.glsl"

// Bilinear in the full-size texture that begins at texel `first`.
float map_value(int first, ivec2 size, int wrap_u, int wrap_v, vec2 uv) {
    vec2 at = texel_place(uv, size);
    ivec2 corner = ivec2(floor(at));
    vec2 f = at - floor(at);
    int x0 = wrapped(corner.x, size.x, wrap_u);
    int x1 = wrapped(corner.x + 1, size.x, wrap_u);
    int row0 = first + size.x * wrapped(corner.y, size.y, wrap_v);
    int row1 = first + size.x * wrapped(corner.y + 1, size.y, wrap_v);
    return mix(mix(texelFetch(alpha_texels, row0 + x0).r, texelFetch(alpha_texels, row0 + x1).r, f.x),
               mix(texelFetch(alpha_texels, row1 + x0).r, texelFetch(alpha_texels, row1 + x1).r, f.x), f.y);
}

float map_alpha(Caster caster, vec2 uv) {
    return map_value(caster.map, caster.map_size, caster.wrap_u, caster.wrap_v, uv);
}

// Transmittance at a point of the triangle, given by the barycentric weights of its corners. `corners`: texel of its alpha corners.
float transmittance_at(Caster caster, int corners, vec3 weights) {
    if (caster.alpha_mode == opaque_mode) return 0.0;
    vec3 mean = weights.x * texelFetch(caster_data, corners).xyz + weights.y * texelFetch(caster_data, corners + 1).xyz
                + weights.z * texelFetch(caster_data, corners + 2).xyz; // u, v, alpha
    float alpha = mean.z;
    if (caster.map_size.x > 0) alpha *= map_alpha(caster, mean.xy);
    if (caster.alpha_mode == mask_mode) return alpha < caster.alpha_cutoff ? 1.0 : 0.0;
    return 1.0 - clamp(alpha, 0.0, 1.0);
}
