// The current material. Keep in sync with MaterialBlock in src/render/gpu/blocks.hpp.
#include "interface/texture_inputs.glsl"

layout(std140) uniform Material {
    vec4 base_color_factor;
    vec4 emission_factor;       // rgb: L_e [cd/m²]
    vec4 specular_color_factor; // rgb: specular colour, a: specular
    vec4 anisotropy_factor;     // strength, cos and sin of the rotation
    vec4 clearcoat_factor;      // clearcoat, roughness, normal scale
    vec4 sheen_factor;          // rgb: colour, a: roughness
    vec4 iridescence_factor;    // iridescence, ior of the film, its least and largest thickness [nm]
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
