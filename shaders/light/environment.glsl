// Light from infinitely far, from every direction: of one radiance, or of an equirectangular picture.
//
//   constant   p(wi) = 1 / 4π                                             [1/sr]
//   a picture  p(wi) = P(row) P(texel | row) / Ω_texel
//
// A picture's middle column shows -Z and the one a quarter of the width to its right +X, +Y is up; then the emitter's
// rotation around +Y. Radiance is bilinear between the middles of texels. A row is chosen by its light and then a texel
// of it, by inverting their cdf, which keeps well spread random numbers well spread (Pharr, Jakob & Humphreys 2016,
// section 14.2.4); the light of a texel is the mean of the bilinear radiance over it. In the texel all directions are
// as likely. Limit: random numbers have 24 bits, so what has less than 2^-24 of the light of its row is hardly ever
// chosen; directions of the BRDF's choice find it. Keep in sync with src/render/gpu/light_texels.hpp.
#include "base/angle.glsl"
#include "interface/features.glsl"
#include "interface/lights.glsl"
#include "light/cdf.glsl"
#include "light/light_sample.glsl"

const float min_density = 1e-15; // in the place of 0, for directions that sampling does not find [1/sr]

bool has_picture(Light light) { return has_environment_maps && light.count > 0; }

vec3 picture_from_world(Light light, vec3 w) {
    float c = light.direction.x, s = light.direction.y;
    return vec3(c * w.x - s * w.z, w.y, s * w.x + c * w.z);
}

vec3 world_from_picture(Light light, vec3 w) {
    float c = light.direction.x, s = light.direction.y;
    return vec3(c * w.x + s * w.z, w.y, c * w.z - s * w.x);
}

// Where w is in the picture, in texels from its upper left corner.
vec2 picture_place(Light light, vec3 w) {
    vec3 v = picture_from_world(light, w);
    return vec2(angle_of(vec2(-v.z, v.x)) / (2.0 * pi) + 0.5, angle_of(vec2(v.y, length(v.xz))) / pi) * light.half_u.xy;
}

vec3 picture_texel(Light light, int i, int j) {
    int width = int(light.half_u.x);
    int height = int(light.half_u.y);
    int column = i < 0 ? i + width : (i < width ? i : i - width);
    return texelFetch(environment_texels, light.data + height + clamp(j, 0, height - 1) * width + column).rgb;
}

vec3 picture_radiance(Light light, vec2 place) {
    vec2 at = place - 0.5;
    vec2 f = at - floor(at);
    int i = int(floor(at.x));
    int j = int(floor(at.y));
    return mix(mix(picture_texel(light, i, j), picture_texel(light, i + 1, j), f.x),
               mix(picture_texel(light, i, j + 1), picture_texel(light, i + 1, j + 1), f.x), f.y);
}

// L_e from the direction wi [cd/m²].
vec3 environment_radiance(Light light, vec3 wi) {
    if (!has_picture(light)) return light.quantity;
    return light.quantity * picture_radiance(light, picture_place(light, wi));
}

LightSample sample_picture(Light light, vec2 u) {
    int width = int(light.half_u.x);
    int height = int(light.half_u.y);
    int texels = light.data + height;
    int guides = texels + width * height;
    CdfEntry row = cdf_entry(light.data, height, guides, u.y);
    int guide = guides + guide_texels(height) + row.i * guide_texels(width);
    CdfEntry column = cdf_entry(texels + row.i * width, width, guide, u.x);
    vec4 heights = texelFetch(environment_texels, light.data + row.i);
    float off_pole = mix(heights.y, heights.z, row.u); // 1 - cosθ from the nearer pole
    float y = 2 * row.i < height ? 1.0 - off_pole : off_pole - 1.0;
    float across = sqrt(off_pole * (2.0 - off_pole));
    float phi = 2.0 * pi * ((float(column.i) + column.u) / light.half_u.x - 0.5);
    vec3 wi = normalize(world_from_picture(light, vec3(across * sin(phi), y, -across * cos(phi))));
    float p = heights.x * column.share;
    return light_sample(wi, infinitely_far, environment_radiance(light, wi), max(p, min_density));
}

LightSample sample_environment(Light light, vec2 u) {
    if (has_picture(light)) return sample_picture(light, u);
    float y = 1.0 - 2.0 * u.y;
    float across = 2.0 * sqrt(u.y * (1.0 - u.y));
    vec3 wi = normalize(vec3(across * cos(2.0 * pi * u.x), y, across * sin(2.0 * pi * u.x)));
    return light_sample(wi, infinitely_far, light.quantity, 1.0 / (4.0 * pi));
}

LightSample environment_along(Light light, vec3 wi) {
    if (!has_picture(light)) return light_sample(wi, infinitely_far, light.quantity, 1.0 / (4.0 * pi));
    vec2 place = picture_place(light, wi);
    ivec2 size = ivec2(light.half_u.xy);
    ivec2 at = clamp(ivec2(place), ivec2(0), size - 1);
    float p = texelFetch(environment_texels, light.data + at.y).x * cdf_share(light.data + size.y + at.y * size.x, at.x);
    return light_sample(wi, infinitely_far, light.quantity * picture_radiance(light, place), max(p, min_density));
}
