#version 410 core
// Not the equation, but your functions made visible: a globe of (θ, φ), the spectrum, and your lamp's colour.
#include "assignment/not_implemented.glsl"
#include "directions.glsl"
#include "spectrum.glsl"
#include "surface/at_fragment.glsl"

out vec4 film;

// Squares of 15° in both angles. The column that begins at φ = 0 is red, the one at φ = 90° green.
vec3 globe(vec3 w) {
    vec2 a = angles(w);
    vec2 cell = floor(vec2(a.x, mod(a.y, 2.0 * pi)) / radians(15.0));
    vec3 color = cell.y == 0.0 ? vec3(1.0, 0.25, 0.2) : cell.y == 6.0 ? vec3(0.25, 0.8, 0.3) : vec3(0.8);
    float shade = 0.65 + 0.35 * dot(direction(a.x, a.y), normalize(vec3(0.8, 0.3, 0.5)));
    return shade * (mod(cell.x + cell.y, 2.0) == 0.0 ? color : 0.4 * color);
}

// Above: narrow lamps of 1 W from 380 to 780 nm. Below: your lamp. Colours that a screen cannot show are cut off here.
vec3 strip(vec2 place) {
    if (place.y < 0.0) return max(vec3(0.0), RGB_of_your_lamp());
    return max(vec3(0.0), RGB_of_XYZ(XYZ_of_lamp(1.0, mix(shortest, longest, place.x), 10.0)));
}

void main() {
    Surface x = surface_at_fragment();
    bool is_globe = x.position.z > -1.1;
    float along = dot(x.position.xy, vec2(-sqrt(0.5), sqrt(0.5)));
    film = vec4(is_globe ? globe(x.n) : strip(vec2(along / 2.8 + 0.5, x.position.z + 1.45)), 1.0);
    if (not_implemented_calls > 0) film = not_implemented(); // magenta, where a function is still to be written
}
