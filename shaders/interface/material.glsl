// The current material: the textures that it can have, in the order of texture_inputs in src/scene/material.hpp, and
// its factors, as MaterialBlock in src/render/gpu/blocks.hpp has them. Tests compare both.
const int base_color_slot = 0;
const int metallic_roughness_slot = 1;
const int normal_slot = 2;
const int emission_slot = 3;
const int specular_slot = 4;
const int specular_color_slot = 5;
const int anisotropy_slot = 6;
const int clearcoat_slot = 7;
const int clearcoat_roughness_slot = 8;
const int clearcoat_normal_slot = 9;
const int sheen_color_slot = 10;
const int sheen_roughness_slot = 11;
const int iridescence_slot = 12;
const int film_thickness_slot = 13;
const int transmission_slot = 14;
const int thickness_slot = 15;
const int diffuse_transmission_slot = 16;
const int diffuse_transmission_color_slot = 17;
const int slot_count = 18;

uniform sampler2D base_color_texture;
uniform sampler2D metallic_roughness_texture;
uniform sampler2D normal_texture;
uniform sampler2D emission_texture;
uniform sampler2D specular_texture;
uniform sampler2D specular_color_texture;
uniform sampler2D anisotropy_texture;
uniform sampler2D clearcoat_texture;
uniform sampler2D clearcoat_roughness_texture;
uniform sampler2D clearcoat_normal_texture;
uniform sampler2D sheen_color_texture;
uniform sampler2D sheen_roughness_texture;
uniform sampler2D iridescence_texture;
uniform sampler2D film_thickness_texture;
uniform sampler2D transmission_texture;
uniform sampler2D thickness_texture;
uniform sampler2D diffuse_transmission_texture;
uniform sampler2D diffuse_transmission_color_texture;

layout(std140) uniform Material {
    vec4 base_color_factor;
    vec4 emission_factor;       // rgb: L_e [cd/m²]
    vec4 specular_color_factor; // rgb: specular colour, a: specular
    vec4 anisotropy_factor;     // strength, cos and sin of the rotation
    vec4 clearcoat_factor;      // clearcoat, roughness, normal scale
    vec4 sheen_factor;          // rgb: colour, a: roughness
    vec4 iridescence_factor;    // iridescence, ior of the film, its smallest and largest thickness [nm]
    vec4 transmission_factor;   // transmission, thickness [m] in the mesh's space
    vec4 attenuation_factor;    // rgb: σ [1/m]
    vec4 diffuse_transmission_factor; // rgb: colour, a: share of the diffuse base
    vec4 model_parameters[4];   // of the BRDF, which its file in brdf/models/ names
    float metallic_factor;
    float roughness_factor;
    float normal_scale;
    float alpha_cutoff;
    float F0_from_ior;          // ((ior - 1) / (ior + 1))²
    vec4 uv_row_u[slot_count];  // KHR_texture_transform: u' = dot(row.xyz, (u, v, 1)); w: texture coordinate set
    vec4 uv_row_v[slot_count];
};
