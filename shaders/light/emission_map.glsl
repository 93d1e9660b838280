// The texture of an emitter: its texel multiplies L_e. Read bilinearly at full resolution, as glTF's samplers ask
// for magnification (glTF 2.0, section 3.8.4). Keep in sync with src/render/gpu/light_texels.hpp.
#include "base/texel_wrap.glsl"
#include "interface/features.glsl"
#include "interface/lights.glsl"

uniform samplerBuffer emission_texels; // blocks, each of a cell of side × side texels of a map
const int log2_side = 5;
const int side_mask = (1 << log2_side) - 1;

// The texel (x, y) of a map of this width. The blocks of its cells follow its description in the light table, row by row.
vec3 emission_texel(int map, int width, int x, int y) {
    int cells = (width + side_mask) >> log2_side; // of a row
    int cell = cells * (y >> log2_side) + (x >> log2_side);
    int block = int(texelFetch(light_table, map + 1 + cell).x);
    int texel = ((y & side_mask) << log2_side) + (x & side_mask);
    return texelFetch(emission_texels, (block << 2 * log2_side) + texel).rgb;
}

// The colour of the map whose description is texel `map` of the light table; white for a negative one.
vec3 emission_map(int map, vec2 uv) {
    if (!has_emission_maps || map < 0) return vec3(1.0);
    vec4 place = texelFetch(light_table, map); // width, height, wrap_u + 4 wrap_v
    int width = int(place.x);
    int height = int(place.y);
    int wrap_u = int(place.z) & 3;
    int wrap_v = int(place.z) >> 2;
    vec2 at = texel_place(uv, ivec2(width, height));
    ivec2 corner = ivec2(floor(at));
    vec2 f = at - floor(at);
    int x0 = wrapped(corner.x, width, wrap_u);
    int x1 = wrapped(corner.x + 1, width, wrap_u);
    int y0 = wrapped(corner.y, height, wrap_v);
    int y1 = wrapped(corner.y + 1, height, wrap_v);
    return mix(mix(emission_texel(map, width, x0, y0), emission_texel(map, width, x1, y0), f.x),
               mix(emission_texel(map, width, x0, y1), emission_texel(map, width, x1, y1), f.x), f.y);
}

// The colour at the point (s, t) of a flat emitter.
vec3 emission_at(Light light, vec2 st) {
    return emission_map(light.map, light.uv_origin + st.x * light.uv_along_u + st.y * light.uv_along_v);
}
