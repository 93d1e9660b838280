#version 410 core
// The film on a screen: what the viewer's window shows behind its panels.
#include "display/choice.glsl"
#include "display/colormap.glsl"
#include "display/view.glsl"

uniform sampler2D film_sum;  // the sum of all samples
uniform float film_weight;   // 1 / their number
uniform sampler2D pixel_weights; // of the film's pixels that rest 1 / their number; 0 of the others
uniform sampler2D other_sum; // what it is compared with
uniform float other_weight;
uniform vec2 corner;       // the picture's lower left in the window
uniform vec2 picture_size; // in the window
uniform float exposure;
uniform vec2 decades; // powers of ten [cd/m²] at the ends of the colour map
uniform float wipe;             // where the other picture begins, 0 to 1

out vec4 screen;

vec4 mean(sampler2D sum, float weight, bool has_rest, ivec2 at) {
    if (has_rest) weight = max(weight, texelFetch(pixel_weights, at, 0).r);
    return texelFetch(sum, at, 0) * weight;
}

vec2 place() { return gl_FragCoord.xy - corner; }

// Pixel by pixel where the film has the picture's size, else bilinear in linear light.
vec4 radiance(sampler2D sum, float weight, bool has_rest) {
    if (!is_scaled) return mean(sum, weight, has_rest, ivec2(place()));
    vec2 size = vec2(textureSize(sum, 0));
    vec2 at = place() * size / picture_size - 0.5;
    ivec2 low = ivec2(floor(at + 1e-3)); // a pixel's centre must not fall below itself by rounding
    vec2 between = clamp(at - vec2(low), 0.0, 1.0);
    ivec2 last = ivec2(size) - 1;
    vec4 rows[2];
    for (int y = 0; y < 2; ++y) {
        vec4 left = mean(sum, weight, has_rest, clamp(low + ivec2(0, y), ivec2(0), last));
        vec4 right = mean(sum, weight, has_rest, clamp(low + ivec2(1, y), ivec2(0), last));
        rows[y] = mix(left, right, between.x);
    }
    return mix(rows[0], rows[1], between.y);
}

vec4 other_radiance() { return radiance(other_sum, other_weight, false); }

vec3 shown(vec4 film) {
    if (view_kind != exposed_view) return view_color(film);
    vec3 L = film.rgb;
    if (!is_false_color) return displayed(L, exposure);
    if (!is_finite(L)) return vec3(1.0, 0.0, 1.0);
    return luminance_color(luminance(L), decades);
}

vec3 shown_film(vec4 film) { return is_film_displayed ? srgb_encoded(film.rgb) : shown(film); }

vec3 shown_other() {
    vec4 other = other_radiance();
    return is_other_displayed ? srgb_encoded(other.rgb) : shown(other);
}

// Blue where the film is darker than the other, orange where it is brighter, grey where they agree; full at one half.
vec3 difference(vec3 L, vec3 other) {
    float a = luminance(L), b = luminance(other);
    float relative = (a - b) / max(max(a, b), 1e-30);
    if (!is_finite(L) || !is_finite(other)) return vec3(1.0, 0.0, 1.0);
    vec3 end = relative > 0.0 ? vec3(0.902, 0.624, 0.0) : vec3(0.0, 0.447, 0.698);
    return mix(vec3(0.5), end, clamp(2.0 * abs(relative), 0.0, 1.0));
}

void main() {
    vec4 film = radiance(film_sum, film_weight, has_frozen_pixels);
    vec3 L = film.rgb;
    vec3 color = shown_film(film);
    if (comparison == 2) { // of what a screen shows if one of them is that
        vec3 there = other_radiance().rgb;
        if (is_other_displayed && !is_film_displayed) L = clamp(toned(L * exposure), 0.0, 1.0);
        if (is_film_displayed && !is_other_displayed) there = clamp(toned(there * exposure), 0.0, 1.0);
        color = difference(L, there);
    }
    if (comparison == 3) color = colormap(other_radiance().r);
    if (comparison == 1) {
        float edge = place().x - wipe * picture_size.x;
        if (edge > 0.0) color = shown_other();
        if (abs(edge) < 1.0) color = vec3(1.0);
    }
    screen = vec4(color, 1.0);
}
