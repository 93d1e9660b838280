#version 410 core
// The depth pre-pass: which surface a pixel sees. alphaMode MASK has a say, and where glass is opaque.
#include "surface/textures.glsl"

void main() {
    if (is_masked && base_color().a < alpha_cutoff) discard;
    if (is_other_part()) discard;
}
