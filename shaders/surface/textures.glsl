// Reads the material's textures through their coordinate sets and transforms.
#include "interface/features.glsl"
#include "interface/fragment.glsl"
#include "interface/material.glsl"

vec2 uv(int slot) {
    vec4 row_u = uv_row_u[slot];
    vec4 row_v = uv_row_v[slot];
    vec3 set = vec3(row_u.w == 0.0 ? vertex_uv0 : vertex_uv1, 1.0);
    return vec2(dot(row_u.xyz, set), dot(row_v.xyz, set));
}

vec4 base_color() {
    vec4 color = base_color_factor;
    if (has_vertex_colors) color *= vertex_color;
    if (has_base_color_texture) color *= texture(base_color_texture, uv(base_color_slot));
    return color;
}

// (roughness, metallic)
vec2 roughness_metallic() {
    vec2 factors = vec2(roughness_factor, metallic_factor);
    if (has_metallic_roughness_texture)
        factors *= texture(metallic_roughness_texture, uv(metallic_roughness_slot)).gb;
    return factors;
}

vec3 emission() {
    vec3 L_e = emission_factor.rgb;
    if (has_emission_texture) L_e *= texture(emission_texture, uv(emission_slot)).rgb;
    return L_e;
}

// (specular colour, specular)
vec4 specular() {
    vec4 factors = specular_color_factor;
    if (has_specular_color_texture) factors.rgb *= texture(specular_color_texture, uv(specular_color_slot)).rgb;
    if (has_specular_texture) factors.a *= texture(specular_texture, uv(specular_slot)).a;
    return factors;
}
