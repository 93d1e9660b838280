// The surface whose BRDF is evaluated. Its normal is tilted, so that frames matter. Keep in sync with parameters_of() in
// src/brdf/evaluator.cpp.
#include "surface/surface.glsl"

uniform vec4 parameters[12];

const vec3 subject_n = vec3(0.48, -0.6, 0.64);

Surface subject() {
    Surface x;
    x.position = vec3(0.0);
    x.n = subject_n;
    x.unmapped_n = subject_n;
    x.triangle = 0;
    x.coverage = 1.0;
    x.emission = vec3(0.0);
    x.base_color = parameters[0].rgb;
    x.metallic = parameters[0].a;
    x.F0_dielectric = parameters[1].rgb;
    x.specular = parameters[1].a;
    x.alpha = parameters[2].x;
    x.roughness = parameters[2].y;
    x.alphas = parameters[2].zw;
    x.clearcoat = parameters[3].x;
    x.clearcoat_alpha = parameters[3].y;
    x.exponent = parameters[3].z;
    x.measured_alpha = parameters[3].w;
    x.clearcoat_n = subject_n;
    x.sheen_color = parameters[4].rgb;
    x.sheen_alpha = parameters[4].a;
    x.iridescence = parameters[5].x;
    x.film_ior = parameters[5].y;
    x.film_thickness = parameters[5].z;
    x.ior = parameters[6].rgb;
    x.extinction = parameters[7].rgb;
    x.specular_color = parameters[8].rgb;
    x.diffuse_transmission_color = parameters[10].rgb;
    x.diffuse_transmission = parameters[10].a;
    x.transmission = parameters[11].x;
    // Any unit vector across n, turned by the rotation of the anisotropy.
    vec3 across = normalize(cross(vec3(0.0, 0.0, 1.0), x.n));
    x.t = cos(parameters[9].x) * across + sin(parameters[9].x) * cross(x.n, across);
    return x;
}

// From the frame in which directions are stated: z is n, x is t before it is turned.
mat3 subject_frame() {
    vec3 across = normalize(cross(vec3(0.0, 0.0, 1.0), subject_n));
    return mat3(across, cross(subject_n, across), subject_n);
}
