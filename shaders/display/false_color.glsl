// Luminance as a colour that also colour-blind people can order: viridis (Smith & van der Walt 2015), nine of its
// colours and straight lines between them. Its lightness rises evenly, so it survives being printed in grey.

const vec3 viridis[9] = vec3[](vec3(0.267, 0.005, 0.329), vec3(0.279, 0.175, 0.483), vec3(0.230, 0.322, 0.546),
                               vec3(0.173, 0.449, 0.558), vec3(0.128, 0.567, 0.551), vec3(0.153, 0.681, 0.504),
                               vec3(0.360, 0.785, 0.388), vec3(0.668, 0.862, 0.196), vec3(0.993, 0.906, 0.144));

// Code values of a screen; `place` from 0 to 1.
vec3 false_color(float place) {
    float at = clamp(place, 0.0, 1.0) * 8.0;
    int below = min(int(at), 7);
    return mix(viridis[below], viridis[below + 1], at - float(below));
}

// Y of linear Rec. 709 (ITU-R BT.709-6, item 3.2).
float luminance(vec3 rgb) { return dot(rgb, vec3(0.2126, 0.7152, 0.0722)); }
