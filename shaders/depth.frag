#version 410 core
// The depth pre-pass: which surface a pixel sees. Only alphaMode MASK has a say.
#include "surface/textures.glsl"

void main() {
    if (is_masked && base_color().a < alpha_cutoff) discard;
}
