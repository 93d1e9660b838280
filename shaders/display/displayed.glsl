// From radiance to the code values of a screen, as src/image/display.cpp does it for 8-bit files.
#include "display/shown_curve.glsl"

// IEC 61966-2-1.
vec3 srgb_encoded(vec3 light) {
    vec3 x = clamp(light, 0.0, 1.0);
    return mix(1.055 * pow(max(x, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}

bool is_finite(vec3 v) { return !any(isnan(v)) && !any(isinf(v)); }

// Linear light of a screen.
vec3 toned(vec3 exposed) { return shown_curve(max(exposed, 0.0)); }

// `exposure` is 1 / (1.2 * 2^EV100) (Lagarde & de Rousiers 2014, section 5.1.2). Holes come out magenta.
vec3 displayed(vec3 L, float exposure) {
    return is_finite(L) ? srgb_encoded(toned(L * exposure)) : vec3(1.0, 0.0, 1.0);
}
