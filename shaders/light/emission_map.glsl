// The texture of an emitter: its texel multiplies L_e. Read bilinearly at full resolution, as glTF's samplers ask
// for magnification (glTF 2.0, section 3.8.4). Keep in sync with src/render/gpu/light_texels.hpp.
#include "base/texel_wrap.glsl"
#include "interface/features.glsl"
#include "interface/lights.glsl"

uniform samplerBuffer emission_texels;

// The colour of the map whose description is texel `map` of the light table; white for a negative one.
vec3 emission_map(int map, vec2 uv) {
    if (!has_emission_maps || map < 0) return vec3(1.0);
    vec4 place = texelFetch(light_table, map); // first texel, width, height, wrap_u + 4 wrap_v
    int width = int(place.y);
    int height = int(place.z);
    int wrap_u = int(place.w) & 3;
    int wrap_v = int(place.w) >> 2;
    vec2 at = texel_place(uv, ivec2(width, height));
    ivec2 corner = ivec2(floor(at));
    vec2 f = at - floor(at);
    int x0 = wrapped(corner.x, width, wrap_u);
    int x1 = wrapped(corner.x + 1, width, wrap_u);
    int row0 = int(place.x) + width * wrapped(corner.y, height, wrap_v);
    int row1 = int(place.x) + width * wrapped(corner.y + 1, height, wrap_v);
    return mix(mix(texelFetch(emission_texels, row0 + x0).rgb, texelFetch(emission_texels, row0 + x1).rgb, f.x),
               mix(texelFetch(emission_texels, row1 + x0).rgb, texelFetch(emission_texels, row1 + x1).rgb, f.x), f.y);
}

// The colour at the point (s, t) of a flat emitter.
vec3 emission_at(Light light, vec2 st) {
    return emission_map(light.map, light.uv_origin + st.x * light.uv_along_u + st.y * light.uv_along_v);
}
