// Pictures of views, as src/output/variables.cpp makes them for files.
#include "display/choice.glsl"
#include "display/displayed.glsl"

const int exposed_view = 0;  // shown as radiance
const int share_view = 1;    // 0 to 1 in red, green and blue
const int quotient_view = 2; // red over green
const int leak_view = 3;     // red and green over blue

// Code values for a film's pixel; not for exposed_view.
vec3 view_color(vec4 film) {
    if (view_kind == share_view) return srgb_encoded(film.rgb);
    float nothing = film.a > 0.0 ? view_without : 0.0;
    if (view_kind == quotient_view) return srgb_encoded(vec3(film.g > 0.0 ? film.r / film.g : nothing));
    vec2 share = film.b > 0.0 ? film.rg / film.b : vec2(nothing);
    float kept_out = max(share.g - share.r, 0.0);
    float base = 0.1 * film.a * (1.0 - share.r - kept_out);
    return srgb_encoded(vec3(base + share.r, base, base + kept_out));
}
