// Irradiance at x from one point on a light, independent of the BRDF: the light sample of reflected.glsl.
//
//   E = L_i/p · V · cosθ_i          [lx]
#include "integrator/cosine.glsl"
#include "integrator/point_on_light.glsl"
#include "surface/surface.glsl"

struct Incident {
    LightSample light;
    vec3 E;            // [lx]
    vec3 E_unshadowed; // [lx]
};

Incident incident_from(int k, Surface x) {
    LightSample light = point_on_light(k, x);
    float cos_i = cosine(x, light.wi);
    if (!(cos_i > 0.0)) return Incident(light, vec3(0.0), vec3(0.0));
    vec3 E = light.Li_over_p * cos_i;
    return Incident(light, E * V_of_point(k, x, light), E);
}

// 1/p, whose mean is the solid angle of an area light [sr]; 0 for emitters without extent.
float solid_angle_of(int k, LightSample light) {
    if (light.p > 0.0) return 1.0 / light.p;
    Light from = light_at(k);
    if (from.kind != mesh_light || from.quantity == vec3(0.0)) return 0.0;
    vec3 L = from.quantity; // untextured: L_e / p over L_e, by the channel that has most
    int channel = L.r >= max(L.g, L.b) ? 0 : L.g >= L.b ? 1 : 2;
    return light.Li_over_p[channel] / L[channel];
}

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); } // Rec. 709
