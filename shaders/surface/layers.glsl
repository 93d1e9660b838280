// add_layers(): what the equation reads of a material's layers at a point (KHR_materials_*), from their factors and textures.
#include "brdf/coat.glsl"
#include "surface/shading_normal.glsl"
#include "surface/surface.glsl"
#include "surface/textures.glsl"

// The direction in the tangent plane that the lobe is stretched along, and by how much (KHR_materials_anisotropy).
vec3 anisotropy() {
    vec2 turn = anisotropy_factor.yz;
    if (!has_anisotropy_texture) return vec3(turn, anisotropy_factor.x);
    vec3 texel = texel(anisotropy_texture, anisotropy_slot).xyz;
    vec2 along = texel.xy * 2.0 - 1.0; // texels without a direction say +X
    along = dot(along, along) > 1e-3 ? normalize(along) : vec2(1.0, 0.0);
    return vec3(turn.x * along.x - turn.y * along.y, turn.y * along.x + turn.x * along.y, anisotropy_factor.x * texel.z);
}

// KHR_materials_anisotropy: along t the width grows, across it stays.
void add_anisotropy(inout Surface x) {
    vec3 along = anisotropy();
    vec3 t = from_tangent_space(vec3(along.xy, 0.0));
    x.t = unit_or(t - dot(x.n, t) * x.n, frame_around(x.n)[0]);
    x.alphas = vec2(mix(x.alpha, 1.0, along.z * along.z), x.alpha);
}

// (clearcoat, its roughness)
vec2 clearcoat() {
    vec2 factors = clearcoat_factor.xy;
    if (has_clearcoat_texture) factors.x *= texel(clearcoat_texture, clearcoat_slot).r;
    if (has_clearcoat_roughness_texture) factors.y *= texel(clearcoat_roughness_texture, clearcoat_roughness_slot).g;
    return factors;
}

void add_clearcoat(inout Surface x, vec3 wo) {
    vec2 coat = clamp(clearcoat(), 0.0, 1.0);
    x.clearcoat = coat.x;
    x.clearcoat_alpha = alpha_of(coat.y);
    x.clearcoat_n = on_seen_side(mapped_clearcoat_normal(), wo);
    x.emission *= 1.0 - coat_weight(x, wo); // the coat lies over what emits
}

// (colour, roughness)
vec4 sheen() {
    vec4 factors = sheen_factor;
    if (has_sheen_color_texture) factors.rgb *= texel(sheen_color_texture, sheen_color_slot).rgb;
    if (has_sheen_roughness_texture) factors.a *= texel(sheen_roughness_texture, sheen_roughness_slot).a;
    return factors;
}

void add_sheen(inout Surface x) {
    vec4 s = clamp(sheen(), 0.0, 1.0);
    x.sheen_color = s.rgb;
    x.sheen_alpha = alpha_of(s.a);
}

// (weight, thickness [nm])
vec2 iridescence() {
    vec2 film = iridescence_factor.xw;
    if (has_iridescence_texture) film.x *= texel(iridescence_texture, iridescence_slot).r;
    if (has_film_thickness_texture)
        film.y = mix(iridescence_factor.z, film.y, texel(film_thickness_texture, film_thickness_slot).g);
    return film;
}

void add_iridescence(inout Surface x) {
    vec2 film = iridescence();
    x.iridescence = clamp(film.x, 0.0, 1.0);
    x.film_ior = iridescence_factor.y;
    x.film_thickness = film.y;
}

// (colour, share of the diffuse base)
vec4 diffuse_transmission() {
    vec4 factors = diffuse_transmission_factor;
    if (has_diffuse_transmission_color_texture)
        factors.rgb *= texel(diffuse_transmission_color_texture, diffuse_transmission_color_slot).rgb;
    if (has_diffuse_transmission_texture)
        factors.a *= texel(diffuse_transmission_texture, diffuse_transmission_slot).a;
    return factors;
}

void add_diffuse_transmission(inout Surface x) {
    vec4 diffuse = clamp(diffuse_transmission(), 0.0, 1.0);
    x.diffuse_transmission = diffuse.a;
    x.diffuse_transmission_color = diffuse.rgb;
}

void add_layers(inout Surface x, vec3 wo) {
    if (has_anisotropy) add_anisotropy(x);
    if (has_clearcoat) add_clearcoat(x, wo);
    if (has_sheen) add_sheen(x);
    if (has_iridescence) add_iridescence(x);
    if (is_transmissive) x.transmission = clamp(transmission(), 0.0, 1.0);
    if (has_diffuse_transmission) add_diffuse_transmission(x);
}
