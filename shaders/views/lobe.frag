#version 410 core
// f_r(x, wi, wo) [1/sr] for one given wi; of a mirror, whose f_r is a delta, the reflectance ρ. Unlit surfaces reflect nothing.
#include "surface/surface.glsl"
#include "brdf/f_r.glsl"
#include "surface/at_fragment.glsl"

uniform vec3 asked_wi; // unit

out vec4 film;

void main() {
    Surface x = surface_at_fragment();
    vec3 f = is_mirror ? x.base_color : f_r(x, asked_wi, direction_to_viewer());
    film = vec4(is_unlit ? vec3(0.0) : f, 1.0);
}
