// The surface whose BRDF is evaluated: the current material without a mesh. Its normal is tilted, so that frames matter.
#include "surface/material.glsl"
#include "surface/surface.glsl"

Surface surface_from_parameters(vec3 wo) {
    Surface x;
    x.position = vec3(0.0);
    x.n = tilted_n;
    x.unmapped_n = tilted_n;
    x.triangle = 0;
    x.coverage = 1.0;
    add_material(x, base_color(), wo);
    return x;
}

// From the frame in which directions are stated: z is n, x is the tangent.
mat3 tilted_frame() { return mat3(tilted_t, cross(tilted_n, tilted_t), tilted_n); }
