// Leaves out what an opaque surface does not cover: alphaMode MASK has a say, and where glass is opaque.
#include "surface/textures.glsl"

void cut_out() {
    if (is_masked && base_color().a < alpha_cutoff) discard;
    if (is_other_part()) discard;
}
