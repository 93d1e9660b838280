// The shadow casters, in buffer textures. Keep in sync with src/render/gpu_casters.cpp.
uniform isamplerBuffer bvh_nodes;       // two texels a box, see visibility/bvh.glsl
uniform samplerBuffer caster_triangles; // three texels a triangle, in the order of the leaves: its corners [m];
                                        // w: texel of its caster, texel of its corners, texel of its glass or 0;
                                        // the first negative: plain
uniform isamplerBuffer triangle_places; // where among them the triangle of an index is; negative: nowhere
uniform samplerBuffer caster_data;      // two texels a caster; behind them the alpha corners, three texels a triangle,
                                        // then the glass, seven texels each, and its corners, nine texels a triangle
uniform samplerBuffer alpha_texels;     // of glass also other channels, linear

const int opaque_mode = 0; // scene::AlphaMode
const int mask_mode = 1;
const int blend_mode = 2;

// Data shared by the triangles of one instance. Plain ones, which block everything, have none.
struct Caster {
    int first_light;  // the lights that this surface is
    int end_light;
    float own_share;  // a ray to one of them ignores hits within this last part of its length
    float front;      // of a single-sided surface: 1 on the side of cross(1 - 0, 2 - 0), -1 on the other; 0: both sides block
    int alpha_mode;
    int wrap_u;       // of the alpha map: scene::Wrap
    int wrap_v;
    float alpha_cutoff;
    int map;          // first texel
    ivec2 map_size;   // 0: no map
};

Caster caster_at(int texel) {
    vec4 t0 = texelFetch(caster_data, texel);
    vec4 t1 = texelFetch(caster_data, texel + 1);
    int modes = int(t0.w); // alpha_mode + 4 wrap_u + 16 wrap_v + 64 (0, 1 or 2: front 0, 1 or -1)
    float front = modes < 64 ? 0.0 : modes < 128 ? 1.0 : -1.0;
    return Caster(int(t0.x), int(t0.y), t0.z, front, modes & 3, (modes >> 2) & 3, (modes >> 4) & 3, t1.x, int(t1.y), ivec2(t1.zw));
}
