// A shadow ray as the CPU reads it: from x to the emitter's point [m], and a number > 0 that names it. A light without a place
// has wi there, and the negated number.
const float nowhere = 1e30; // the distance of lights that have no place

vec4 named_ray(vec3 wi, float distance, int name) {
    return distance < nowhere ? vec4(distance * wi, float(name)) : vec4(wi, -float(name));
}
