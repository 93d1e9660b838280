// Reads the material's textures through their coordinate sets and transforms.
#include "interface/features.glsl"
#include "interface/fragment.glsl"
#include "interface/material.glsl"

bool reads_second_set(int slot) { return has_second_uv && uv_row_u[slot].w != 0.0; }

vec2 uv(int slot) {
    vec4 row_u = uv_row_u[slot];
    vec4 row_v = uv_row_v[slot];
    vec3 set = vec3(reads_second_set(slot) ? vertex_uv1 : vertex_uv0, 1.0);
    vec2 at = vec2(dot(row_u.xyz, set), dot(row_v.xyz, set));
    bool is_near = abs(at.x) < 1.6e7 && abs(at.y) < 1.6e7; // 2^24; beyond, floats have no fractions that a sampler could read
    return is_near ? at : vec2(0.0);
}

vec4 texel(sampler2D image, int slot) {
    mat2 uv_from_set = mat2(uv_row_u[slot].x, uv_row_v[slot].x, uv_row_u[slot].y, uv_row_v[slot].y);
    return texel_at(image, uv(slot), uv_from_set, reads_second_set(slot));
}

vec4 base_color() {
    vec4 color = base_color_factor;
    if (has_vertex_colors) color *= vertex_color;
    if (has_base_color_texture) color *= texel(base_color_texture, base_color_slot);
    return color;
}

// 1 - roughness is the factor's times the texel's alpha (KHR_materials_pbrSpecularGlossiness).
float roughness_of_glossiness() {
    float glossiness = 1.0 - roughness_factor;
    if (has_specular_color_texture) glossiness *= texel(specular_color_texture, specular_color_slot).a;
    return 1.0 - glossiness;
}

// An alpha that belongs to another image (src/render/gpu/texture_packing.hpp).
float packed_alpha(sampler2D image, int slot) { return texel(image, slot).a; }

// The base colour's texture holds codes of 8 bits over 256, which half floats are exact for.
vec2 packed_roughness_metallic() {
    return vec2(packed_alpha(base_color_texture, base_color_slot) * (256.0 / 255.0),
                packed_alpha(normal_texture, normal_slot));
}

// (roughness, metallic)
vec2 roughness_metallic() {
    if (is_specular_glossiness) return vec2(roughness_of_glossiness(), 0.0);
    vec2 factors = vec2(roughness_factor, metallic_factor);
    if (has_packed_metallic_roughness)
        factors *= packed_roughness_metallic();
    else if (has_metallic_roughness_texture)
        factors *= texel(metallic_roughness_texture, metallic_roughness_slot).gb;
    return factors;
}

vec3 emission() {
    vec3 L_e = emission_factor.rgb;
    if (has_emission_texture) L_e *= texel(emission_texture, emission_slot).rgb;
    return L_e;
}

// (specular colour, specular)
vec4 specular() {
    vec4 factors = specular_color_factor;
    if (has_specular_color_texture) factors.rgb *= texel(specular_color_texture, specular_color_slot).rgb;
    if (has_specular_texture) factors.a *= texel(specular_texture, specular_slot).a;
    return factors;
}

float transmission() {
    float t = transmission_factor.x;
    if (has_transmission_texture) t *= texel(transmission_texture, transmission_slot).r;
    return t;
}

// [m], in the mesh's space.
float thickness() {
    float d = transmission_factor.y;
    if (has_thickness_texture) d *= texel(thickness_texture, thickness_slot).g;
    return d;
}

// Returns whether the texel is not to be drawn: a material that is glass in part is drawn twice, opaque and blended.
bool is_other_part() {
    if (!is_transmissive || is_blended || !(has_transmission_texture || has_metallic_roughness_texture)) return false;
    bool lets_through = transmission() > 0.0 && roughness_metallic().y < 1.0;
    return lets_through == is_opaque_part;
}
