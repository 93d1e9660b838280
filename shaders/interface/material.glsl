// The material at hand. Mirror: MaterialBlock in src/render/blocks.hpp.
const int base_color_slot = 0;
const int metallic_roughness_slot = 1;
const int normal_slot = 2;
const int emission_slot = 3;
const int specular_slot = 4;
const int specular_color_slot = 5;
const int slot_count = 6;

layout(std140) uniform Material {
    vec4 base_color_factor;
    vec4 emission_factor;       // rgb: L_e [cd/m²]
    vec4 specular_color_factor; // rgb: specular colour, a: specular
    float metallic_factor;
    float roughness_factor;
    float normal_scale;
    float alpha_cutoff;
    float F0_from_ior;          // ((ior - 1) / (ior + 1))²
    vec4 uv_row_u[slot_count];  // KHR_texture_transform: u' = dot(row.xyz, (u, v, 1)); w: texture coordinate set
    vec4 uv_row_v[slot_count];
};

uniform sampler2D base_color_texture;
uniform sampler2D metallic_roughness_texture;
uniform sampler2D normal_texture;
uniform sampler2D emission_texture;
uniform sampler2D specular_texture;
uniform sampler2D specular_color_texture;
