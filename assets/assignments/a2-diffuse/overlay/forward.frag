#version 410 core
// The renderer's equation with your functions in it: each lamp of the scene brings E, and L_o is what the pixel sees.
#include "assignment/not_implemented.glsl"
#include "interface/frame.glsl"
#include "interface/lights.glsl"
#include "room.glsl"
#include "surface/at_fragment.glsl"

out vec4 film; // L_o [cd/m²] and coverage

// KHR_lights_punctual keeps a spot's cone as cosθ · scale + offset.
Lamp lamp_of(Light light) {
    float cos_outer = -light.cone_offset / light.cone_scale;
    return Lamp(light.kind, light.position, light.direction, light.quantity, cos_outer + 1.0 / light.cone_scale, cos_outer);
}

void main() {
    Surface x = surface_at_fragment();
    vec3 E = vec3(0.0);
    for (int k = first_light; k < end_light; ++k) {
        Light light = light_at(k);
        if (light.kind <= directional_light) E += E_of_lamp(lamp_of(light), x.position, x.n);
    }
    film = vec4(L_o(x.emission, x.base_color, E), 1.0);
    if (not_implemented_calls > 0) film = not_implemented(); // magenta, where a function is still to be written
}
