#version 410 core
// A depth map that keeps the triangle in the place of the depth: which shadow caster is the first that light meets.
// Depths are those of the distance along the view, linear, so that far surfaces are resolved as well as near ones.
#include "interface/frame.glsl"
#include "interface/object.glsl"
#include "surface/textures.glsl"
#include "visibility/stochastic_alpha.glsl"

layout(location = 0) out int triangle;

void main() {
    triangle = first_triangle + gl_PrimitiveID;
    if (is_masked && base_color().a < alpha_cutoff) discard;
    if (is_blended && !is_kept(triangle, seed, base_color().a)) discard;
    gl_FragDepth = eye.w == 0.0 ? gl_FragCoord.z : 1.0 / gl_FragCoord.w;
}
