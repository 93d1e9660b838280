// The emitters, eight texels each in a buffer texture, behind them the light tree (light/tree.glsl), then what some of the
// emitters point to, and lists of the lights of each kind. Keep in sync with pack_lights() in src/render/gpu/light_table.cpp.
#include "interface/features.glsl"

uniform samplerBuffer light_table;

struct Light {
    int kind;             // features.glsl numbers them; a point or spot with a radius is a sphere
    vec3 position;        // [m]; of an area light: its centre
    vec3 direction;       // unit: where a spot or directional light goes, where a flat one faces, a profile's axis;
                          // of an environment: cos and sin of its rotation
    vec3 quantity;        // I [cd], E [lx] or L [cd/m²], by kind
    float inverse_range;  // [1/m]; 0: no window
    float cone_scale;     // KHR_lights_punctual: falloff = saturate(cos * scale + offset)²; 0 and 1: no cone
    float cone_offset;
    vec3 half_u;          // half edges or semi-axes [m]; a tube's half axis; with a profile: unit, where φ is 0;
                          // of an environment: its picture's width and height
    vec3 half_v;          // with a profile: unit, where φ is π/2
    bool is_two_sided;
    float radius;         // of a sphere or a tube [m]; of a directional light: angular [rad]
    int data;             // index of the first texel of a polygon's corners, a mesh's triangles or an environment
    int count;            // of these corners or triangles; of an environment: whether it is a picture
    int profile;          // index of a profile's first texel; negative: none
    int map;              // index of an emission map's texel; negative: none
    vec2 uv_origin;       // the map is read at uv_origin + s * uv_along_u + t * uv_along_v
    vec2 uv_along_u;
    vec2 uv_along_v;
};

Light light_at(int index) {
    vec4 t0 = texelFetch(light_table, 8 * index + 0);
    vec4 t1 = texelFetch(light_table, 8 * index + 1);
    vec4 t2 = texelFetch(light_table, 8 * index + 2);
    vec4 t3 = texelFetch(light_table, 8 * index + 3);
    vec4 t4 = texelFetch(light_table, 8 * index + 4);
    vec4 t5 = texelFetch(light_table, 8 * index + 5);
    vec4 t6 = texelFetch(light_table, 8 * index + 6);
    vec4 t7 = texelFetch(light_table, 8 * index + 7);
    Light light;
    light.kind = int(t0.w);
    light.position = t0.xyz;
    light.direction = t1.xyz;
    light.inverse_range = t1.w;
    light.quantity = t2.rgb;
    light.cone_scale = t2.w;
    light.half_u = t3.xyz;
    light.cone_offset = t3.w;
    light.half_v = t4.xyz;
    light.is_two_sided = (int(t4.w) & 1) != 0;
    light.radius = t5.x;
    light.data = int(t5.y);
    light.count = int(t5.z);
    light.profile = int(t5.w);
    light.map = int(t6.x);
    light.uv_origin = t6.yz;
    light.uv_along_u = t7.xy;
    light.uv_along_v = t7.zw;
    return light;
}

// Returns whether single-sided faces that the light meets from behind cast no shadow of it (scene::passes_back_faces).
bool passes_back_faces(int index) { return texelFetch(light_table, 8 * index + 4).w >= 2.0; }

// The light's leaf in the light tree; negative: it sends out nothing.
int leaf_of(int index) { return int(texelFetch(light_table, 8 * index + 6).w); }

// The first texel of the light tree, and its number of nodes.
ivec2 light_tree() { return ivec2(texelFetch(light_table, textureSize(light_table) - 1).xy); }

// The lights of a kind in their order: the first one, and the next one after k. 2^30: there is none.
int lists_of_kinds() { return int(texelFetch(light_table, textureSize(light_table) - 1).z); }
int first_in_table(int kind) { return int(texelFetch(light_table, lists_of_kinds() + kind).x); }
int next_in_table(int k) { return int(texelFetch(light_table, lists_of_kinds() + light_kinds + k).x); }
