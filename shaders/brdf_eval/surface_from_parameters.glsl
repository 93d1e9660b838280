// The surface whose BRDF is evaluated: the current material without a mesh. Its normal is tilted, so that frames matter.
#include "interface/fragment.glsl"
#include "surface/material.glsl"
#include "surface/surface.glsl"

Surface surface_from_parameters(vec3 wo) {
    Surface x;
    x.position = vec3(0.0);
    x.n = vertex_normal;
    x.unmapped_n = vertex_normal;
    x.triangle = 0;
    x.coverage = 1.0;
    add_material(x, base_color(), wo);
    return x;
}

// From the frame in which directions are stated: z is n, x is the tangent.
mat3 tilted_frame() {
    vec3 t = vertex_tangent.xyz;
    return mat3(t, cross(vertex_normal, t), vertex_normal);
}
