// The current material. Keep in sync with MaterialBlock in src/render/blocks.hpp.
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

layout(std140) uniform Material {
    vec4 base_color_factor;
    vec4 emission_factor;       // rgb: L_e [cd/m²]
    vec4 specular_color_factor; // rgb: specular colour, a: specular
    vec4 anisotropy_factor;     // strength, cos and sin of the rotation; w: roughness across the tangent, negative: no other
    vec4 clearcoat_factor;      // clearcoat, roughness, normal scale
    vec4 sheen_factor;          // rgb: colour, a: roughness
    vec4 iridescence_factor;    // iridescence, ior of the film, its least and largest thickness [nm]
    vec4 ior_factor;            // rgb: n of a conductor; w: Phong's exponent
    vec4 extinction_factor;     // rgb: k of a conductor; w: GGX width near a measured lobe
    vec4 transmission_factor;   // transmission, thickness [m] in the mesh's space; w: diffuse transmission
    vec4 attenuation_factor;    // rgb: σ [1/m]
    vec4 diffuse_transmission_color_factor; // rgb
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
