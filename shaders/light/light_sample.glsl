// A direction in which light arrives, and how much of it.
struct LightSample {
    vec3 wi;          // unit, from x to the emitter
    float distance;   // from x to the emitter's point [m]; infinite for directional lights
    vec3 Li_over_p;   // area lights: L_e / p(wi) [lx]; points and spots: I / d² [lx]; directional: E [lx]
    float p;          // p(wi) [1/sr]; 0 for emitters that only sampling themselves can find: those without extent, meshes
};

const float infinitely_far = 1e30;
const LightSample no_light = LightSample(vec3(0.0, 0.0, 1.0), infinitely_far, vec3(0.0), 0.0);

// Light of radiance L_e from a direction that was chosen with density p.
LightSample light_sample(vec3 wi, float distance, vec3 L_e, float p) { return LightSample(wi, distance, L_e / p, p); }
