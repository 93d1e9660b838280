// Colour map of luminance: viridis on a logarithmic scale, as src/image/colormap.cpp does it for files.
// The viewer sets colormap_colors.
#include "display/choice.glsl"

// Y of linear Rec. 709 (ITU-R BT.709-6, item 3.2).
float luminance(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }

// Code values of a screen for `place` from 0 to 1.
vec3 colormap(float place) {
    const int last = colormap_colors.length() - 1;
    float at = clamp(place, 0.0, 1.0) * float(last);
    int i = min(int(at), last - 1);
    return mix(colormap_colors[i], colormap_colors[i + 1], at - float(i));
}

// The colour of luminance Y [cd/m²]; `decades`: the powers of ten at the ends of the scale.
vec3 luminance_color(float Y, vec2 decades) {
    float exponent = log2(max(Y, 1e-30)) * 0.30103; // log10
    return colormap((exponent - decades.x) / (decades.y - decades.x));
}
