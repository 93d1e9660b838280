#version 410 core
// The background of the scene: the environment's radiance in the direction of the pixel. It has no coverage, as nothing of the
// scene is there.
#include "interface/frame.glsl"
#include "light/environment.glsl"

uniform int environment; // its number among the lights

out vec4 frame;

// A point infinitely far in the direction w is at clip_from_world (w, 0): three equations for w, but for its length. An
// orthographic camera looks the same way everywhere.
vec3 direction_of_pixel() {
    if (eye.w == 0.0) return -eye.xyz;
    mat4 rows = transpose(clip_from_world);
    mat3 xyw_from_direction = transpose(mat3(rows[0].xyz, rows[1].xyz, rows[3].xyz));
    return normalize(inverse(xyw_from_direction) * vec3(2.0 * gl_FragCoord.xy / frame_size - 1.0, 1.0));
}

void main() { frame = vec4(environment_radiance(light_at(environment), direction_of_pixel()), 0.0); }
