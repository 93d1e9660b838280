#version 410 core
// Index of the object, index of the material, and depth: the distance from the camera's plane along its
// axis [m]; for an orthographic camera 0 at its near plane and 1 at its far plane. Takes one sample a pixel, since
// the mean of two indices is a third. Of transparent surfaces it is the nearest.
#include "interface/frame.glsl"
#include "interface/object.glsl"
#include "surface/textures.glsl"

out vec4 film;

void main() {
    if (is_masked && base_color().a < alpha_cutoff) discard;
    if (is_blended && base_color().a == 0.0) discard;
    if (is_other_part()) discard;
    film = vec4(object, material, eye.w == 0.0 ? gl_FragCoord.z : 1.0 / gl_FragCoord.w, 1.0);
}
