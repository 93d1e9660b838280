// add_material(): what the equation reads of the current material at a point, from its factors and textures.
#include "brdf/lobe_sum.glsl"
#include "surface/layers.glsl"
#include "surface/surface.glsl"
#include "surface/textures.glsl"

// x has its normal; color: of the base.
void add_material(inout Surface x, vec4 color, vec3 wo) {
    vec2 rm = clamp(roughness_metallic(), 0.0, 1.0);
    vec4 layer = specular();
    x.base_color = color.rgb;
    x.metallic = rm.y;
    x.roughness = rm.x;
    x.alpha = alpha_of(rm.x);
    x.F0_dielectric = min(F0_from_ior * layer.rgb, vec3(1.0));
    x.specular = layer.a;
    // KHR_materials_pbrSpecularGlossiness: c_diff = diffuse (1 - max F0); its F0 is the specular colour (F0_from_ior = 1).
    if (is_specular_glossiness) x.base_color *= 1.0 - largest(x.F0_dielectric);
    x.specular_color = layer.rgb;
    x.emission = emission();
    add_layers(x, wo);
}
