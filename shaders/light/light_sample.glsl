// A direction in which light arrives, and how much of it.
struct LightSample {
    vec3 wi;          // unit, from x to the emitter
    float distance;   // from x to the emitter's point [m]; infinite for directional lights
    vec3 Li_over_p;   // area lights: L_e / p(wi) [lx]; points and spots: I / d² [lx]; directional: E [lx]
    float p;          // p(wi) [1/sr]; 0 for emitters that only sampling themselves can find: those without extent, meshes
};

const float infinitely_far = 1e30;
const LightSample no_light = LightSample(vec3(0.0, 0.0, 1.0), infinitely_far, vec3(0.0), 0.0);

// Bounds far beyond what exists (the sun's disk has 2e9 cd/m², which an environment may find by a density of 1e-15), which
// keep products and sums of samples within float range.
const float max_irradiance = 1e24; // of one sample [lx]
const float max_density = 1e18;    // [1/sr]; its square is a float, too

// Light of radiance L_e from a direction that was chosen with density p. A point without a direction, a distance or a density
// (x on the emitter, an emitter too small for floats) sends nothing.
LightSample light_sample(vec3 wi, float distance, vec3 L_e, float p) {
    if (!(distance > 0.0 && p > 0.0)) return no_light;
    float density = min(p, max_density);
    return LightSample(wi, distance, min(L_e / density, vec3(max_irradiance)), density);
}
