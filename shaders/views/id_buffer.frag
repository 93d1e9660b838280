#version 410 core
// The triangle that the pixel sees: the object's index, and the triangle's index in the object. Takes one sample a pixel and overwrites
// what is behind, so that of transparent surfaces it is the nearest.
#include "interface/object.glsl"
#include "surface/textures.glsl"

out vec4 film;

void main() {
    if (is_masked && base_color().a < alpha_cutoff) discard;
    if (is_blended && base_color().a == 0.0) discard;
    film = vec4(object, gl_PrimitiveID, 0.0, 1.0);
}
