// The emitters, five texels each in a buffer texture. Mirror: pack_lights() in src/render/light_table.cpp.
const int point_light = 0;
const int spot_light = 1;
const int directional_light = 2;
const int rectangle_light = 3;

uniform samplerBuffer light_table;

struct Light {
    int kind;
    vec3 position;        // [m]; of a rectangle: its centre
    vec3 direction;       // unit: where a spot or directional light goes, where a rectangle faces
    vec3 quantity;        // I [cd], E [lx] or L [cd/m²], by kind
    float inverse_range;  // [1/m]; 0: no window
    float cone_scale;     // KHR_lights_punctual: falloff = saturate(cos * scale + offset)²
    float cone_offset;
    vec3 half_u;          // a rectangle's half edges [m]
    vec3 half_v;
    bool is_two_sided;
};

Light light_at(int index) {
    vec4 t0 = texelFetch(light_table, 5 * index + 0);
    vec4 t1 = texelFetch(light_table, 5 * index + 1);
    vec4 t2 = texelFetch(light_table, 5 * index + 2);
    vec4 t3 = texelFetch(light_table, 5 * index + 3);
    vec4 t4 = texelFetch(light_table, 5 * index + 4);
    return Light(int(t0.w), t0.xyz, t1.xyz, t2.rgb, t1.w, t2.w, t3.w, t3.xyz, t4.xyz, t4.w != 0.0);
}
