#version 410 core
// A fragment of the depth pre-pass or of blending as 1: the sum is how many surfaces lie one behind the other.
#include "surface/textures.glsl"

out vec4 film;

void main() {
    if (is_masked && base_color().a < alpha_cutoff) discard;
    if (is_other_part()) discard;
    film = vec4(1.0);
}
