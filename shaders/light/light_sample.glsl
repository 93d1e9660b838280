// A direction in which light arrives, and how much of it.
struct LightSample {
    vec3 wi;          // unit, from x to the emitter
    float distance;   // from x to the emitter's point [m]; infinite for directional lights
    vec3 Li_over_p;   // area lights: L_e / p(wi) [lx]; points and spots: I / d² [lx]; directional: E [lx]
};

const float infinitely_far = 1e30;
