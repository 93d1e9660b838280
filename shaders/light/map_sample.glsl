// Light from the frame's point y on an emitter, the same y for all of the picture (--visibility map).
//
//   flat emitters   y uniform over the area A:                    p(wi) = |x-y|² / (A cosθ_y)                  [1/sr]
//   spheres         y within, density 1 / (π² R³ √(1 - r²/R²)):   p(wi) = (m² + h²/2) / (π R²)
//   tubes           y uniform over the volume:                    p(wi) = (t₂³ - t₁³) / (3 volume)
//   suns            a direction, uniform over the disk            p(wi) = 1 / (2π (1 - cosσ))
//   environments    a direction, as light/environment.glsl samples it, with its density
//
// A point within a convex body stands for the surface before it, so that every y shines on every x. p is the integral
// of the density along the chord [t₁, t₂] = [m - h, m + h], times t²; the density of spheres, in which all directions of
// a far x are as likely, is that of the projection of the 3-sphere (as Archimedes' of the sphere is uniform).
#include "interface/maps.glsl"
#include "light/emission_map.glsl"
#include "light/sample_light.glsl"

LightSample flat_from_point(Light light, MapPoint y, vec3 x) {
    vec3 to_light = y.position - x;
    if (!shines_on(y.normal, x, to_light, light.is_two_sided)) return no_light;
    float d = length(to_light);
    vec3 wi = to_light / d;
    float cos_y = abs(dot(y.normal, wi));
    vec3 L_e = light.quantity * emission_map(light.map, y.uv);
    return light_sample(wi, d, L_e, d * d / (y.extent * cos_y));
}

LightSample sphere_from_point(Light light, MapPoint y, vec3 x) {
    vec3 to_center = light.position - x;
    float r2 = light.radius * light.radius;
    if (dot(to_center, to_center) <= r2) return no_light;
    vec3 wi = normalize(y.position - x);
    float m = dot(wi, to_center);
    vec3 off = to_center - m * wi;
    float h2 = max(r2 - dot(off, off), 0.0);
    return sphere_point(light, to_center, wi, (m * m + 0.5 * h2) / (pi * r2));
}

LightSample tube_from_point(Light light, MapPoint y, vec3 x) {
    vec3 wi = normalize(y.position - x);
    float start = distance_to_tube(tube_from(light, x), wi);
    float beyond = 2.0 * distance(x, y.position); // from there the way back ends where the tube does
    float end = beyond - distance_to_tube(tube_from(light, x + beyond * wi), -wi);
    float r = light.radius;
    float volume = pi * r * r * (2.0 * length(light.half_u) + 4.0 / 3.0 * r);
    float p = (end * end * end - start * start * start) / (3.0 * volume);
    if (!(start > 0.0 && p > 0.0)) return no_light; // x inside, or a ray that only touches
    return light_sample(wi, start, light.quantity, p);
}

LightSample sample_from_point(int k, MapPoint y, vec3 x) {
    Light light = light_at(k);
    if (has_sun_disks && light.kind == directional_light)
        return light_sample(y.position, infinitely_far, sun_radiance(light), p_cone(sun_height(light)));
    if (has_environment_lights && light.kind == environment_light) return environment_along(light, y.position);
    if (has_sphere_lights && light.kind == sphere_light) return sphere_from_point(light, y, x);
    if (has_tube_lights && light.kind == tube_light) return tube_from_point(light, y, x);
    return flat_from_point(light, y, x);
}
