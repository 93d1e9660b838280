// add_material(): what the equation reads of the current material at a point, from its factors and textures.
#include "brdf/coat.glsl"
#include "brdf/lobe_sum.glsl"
#include "surface/shading_normal.glsl"
#include "surface/surface.glsl"

// KHR_materials_anisotropy: along t the width grows, across it stays.
void add_anisotropy(inout Surface x) {
    vec3 along = anisotropy();
    vec3 t = from_tangent_space(vec3(along.xy, 0.0));
    x.t = unit_or(t - dot(x.n, t) * x.n, frame_around(x.n)[0]);
    x.alphas = vec2(mix(x.alpha, 1.0, along.z * along.z), x.alpha);
}

void add_clearcoat(inout Surface x, vec3 wo) {
    vec2 coat = clamp(clearcoat(), 0.0, 1.0);
    x.clearcoat = coat.x;
    x.clearcoat_alpha = alpha_of(coat.y);
    x.clearcoat_n = on_seen_side(mapped_clearcoat_normal(), wo);
    x.emission *= 1.0 - coat_weight(x, wo); // the coat lies over what emits
}

void add_layers(inout Surface x, vec3 wo) {
    if (has_anisotropy) add_anisotropy(x);
    if (has_clearcoat) add_clearcoat(x, wo);
    if (has_sheen) {
        vec4 s = clamp(sheen(), 0.0, 1.0);
        x.sheen_color = s.rgb;
        x.sheen_alpha = alpha_of(s.a);
    }
    if (has_iridescence) {
        vec2 film = iridescence();
        x.iridescence = clamp(film.x, 0.0, 1.0);
        x.film_ior = iridescence_factor.y;
        x.film_thickness = film.y;
    }
}

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
    if (is_transmissive) x.transmission = clamp(transmission(), 0.0, 1.0);
    if (has_diffuse_transmission) {
        vec4 diffuse = clamp(diffuse_transmission(), 0.0, 1.0);
        x.diffuse_transmission = diffuse.a;
        x.diffuse_transmission_color = diffuse.rgb;
    }
}
