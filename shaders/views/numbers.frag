#version 410 core
// Which surface it is and how far: the object's and the material's index, and the distance from the camera's plane along its
// axis [m]; of an orthographic camera the depth, 0 at its near plane and 1 at its far plane. For one sample a pixel, since
// the mean of two indices is a third. Of surfaces that let light through the nearest.
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
