// The emitters, eight texels each in a buffer texture, and behind them what some of them point to.
// Keep in sync with pack_lights() in src/render/light_table.cpp.
const int point_light = 0;
const int spot_light = 1;
const int directional_light = 2;
const int rectangle_light = 3;
const int disk_light = 4;
const int sphere_light = 5;      // also points and spots that have a radius
const int tube_light = 6;
const int polygon_light = 7;
const int mesh_light = 8;
const int environment_light = 9;

uniform samplerBuffer light_table;

struct Light {
    int kind;
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
    return Light(int(t0.w), t0.xyz, t1.xyz, t2.rgb, t1.w, t2.w, t3.w, t3.xyz, t4.xyz, (int(t4.w) & 1) != 0, t5.x, int(t5.y),
                 int(t5.z), int(t5.w), int(t6.x), t6.yz, t7.xy, t7.zw);
}

// Returns whether single-sided faces that the light meets from behind cast no shadow of it (scene::passes_back_faces).
bool passes_back_faces(int index) { return texelFetch(light_table, 8 * index + 4).w >= 2.0; }
