// surface_at_fragment(): from interpolated vertices and textures to the point x of the equation.
#include "brdf/coat.glsl"
#include "brdf/lobe_sum.glsl"
#include "interface/frame.glsl"
#include "interface/object.glsl"
#include "surface/glass.glsl"
#include "surface/shading_normal.glsl"
#include "surface/surface.glsl"

// alpha = roughness²: Burley 2012, section 5.4, and glTF 2.0 Appendix B. A perfect mirror (alpha = 0) has no density
// that a point light could be seen in; below 1e-4 the square of alpha² leaves the range of floats in comfort.
const float smallest_alpha = 1e-4;

float alpha_of(float roughness) { return max(roughness * roughness, smallest_alpha); }

// wo: the unit direction from x to the viewer.
vec3 direction_to_viewer() {
    return eye.w == 0.0 ? eye.xyz : unit_or(eye.xyz - vertex_position, vec3(0.0, 0.0, 1.0));
}

// KHR_materials_anisotropy: along t the width grows, across it stays.
void add_anisotropy(inout Surface x) {
    vec3 along = anisotropy();
    vec3 t = from_tangent_space(vec3(along.xy, 0.0));
    x.t = unit_or(t - dot(x.n, t) * x.n, frame_around(x.n)[0]);
    bool is_stated = anisotropy_factor.w >= 0.0; // extras.steradian
    x.alphas = vec2(is_stated ? x.alpha : mix(x.alpha, 1.0, along.z * along.z),
                    is_stated ? alpha_of(anisotropy_factor.w) : x.alpha);
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

// After the other layers, whose coat lies over the glass.
void add_transmission(inout Surface x, vec3 wo) {
    x.transmission = clamp(transmission(), 0.0, 1.0);
    bool leaves_body = handedness.z != 0.0 && !gl_FrontFacing;
    vec3 optical_depth = leaves_body ? vec3(0.0) : attenuation_factor.rgb * (handedness.y * thickness());
    float F0 = max(x.F0_dielectric.r, max(x.F0_dielectric.g, x.F0_dielectric.b));
    vec3 color = (1.0 - x.metallic) * x.transmission * x.base_color;
    Glass glass = Glass(color, F0, x.specular, has_clearcoat ? x.clearcoat : 0.0, optical_depth);
    vec3 T = straight_transmittance(glass, max(dot(x.n, wo), 0.0));
    x.alpha_coverage = x.coverage;
    x.through = mix(vec3(1.0), T, x.alpha_coverage);
    x.coverage = 1.0 - dot(x.through, vec3(1.0 / 3.0));
}

Surface surface_at_fragment() {
    vec4 color = base_color();
    // The depth pre-pass cuts opaque surfaces out; glass has none.
    if (is_transmissive && is_masked && color.a < alpha_cutoff) discard;
    if (is_other_part()) discard;
    vec2 rm = clamp(roughness_metallic(), 0.0, 1.0);
    vec4 layer = specular();
    vec3 wo = direction_to_viewer();

    Surface x;
    x.position = vertex_position;
    x.triangle = is_line || is_point ? -1 : first_triangle + gl_PrimitiveID;
    x.n = shading_normal(wo);
    x.unmapped_n = on_seen_side(interpolated_normal(), wo);
    x.base_color = color.rgb;
    x.metallic = rm.y;
    x.roughness = rm.x;
    x.alpha = alpha_of(rm.x);
    x.F0_dielectric = min(F0_from_ior * layer.rgb, vec3(1.0));
    x.specular = layer.a;
    // KHR_materials_pbrSpecularGlossiness: c_diff = diffuse (1 - max F0); its F0 is the specular colour (F0_from_ior = 1).
    if (is_specular_glossiness) x.base_color *= 1.0 - largest(x.F0_dielectric);
    x.specular_color = layer.rgb;
    x.ior = ior_factor.rgb;
    x.extinction = extinction_factor.rgb;
    x.exponent = ior_factor.w;
    x.measured_alpha = extinction_factor.w;
    x.emission = emission();
    x.coverage = is_blended ? color.a : 1.0;
    add_layers(x, wo);
    if (is_transmissive) add_transmission(x, wo);
    if (has_diffuse_transmission) {
        vec4 diffuse = clamp(diffuse_transmission(), 0.0, 1.0);
        x.diffuse_transmission = diffuse.a;
        x.diffuse_transmission_color = diffuse.rgb;
    }
    return x;
}
