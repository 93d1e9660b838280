// Photometric profiles: I(γ, φ) on a grid, linear between its angles, nothing beyond its first and last γ.
// γ is the angle to the profile's axis, φ turns around it from half_u to half_v. Keep in sync with src/scene/ies.hpp.
#include "base/constants.glsl"
#include "interface/features.glsl"
#include "interface/lights.glsl"

// Where `angle` lies among `count` ascending ones that start at texel `first`: the interval's index, and how far in.
vec2 interval_of(float angle, int first, int count) {
    int low = 0;
    int high = count - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        bool is_beyond = texelFetch(light_table, first + middle).x <= angle;
        low = is_beyond ? middle : low;
        high = is_beyond ? high : middle;
    }
    float start = texelFetch(light_table, first + low).x;
    float end = texelFetch(light_table, first + high).x;
    return vec2(low, clamp((angle - start) / (end - start), 0.0, 1.0));
}

// I in the direction w, which leaves the light [cd]; 1 for lights without a profile.
float profile_intensity(Light light, vec3 w) {
    if (!has_profiles || light.profile < 0) return 1.0;
    vec4 header = texelFetch(light_table, light.profile);
    int gammas = int(header.x);
    int first_gamma = light.profile + 1;
    int first_phi = first_gamma + gammas;
    int first_I = first_phi + int(header.y);

    float along = dot(w, light.direction);
    float gamma = atan(length(cross(w, light.direction)), along);
    float phi = atan(dot(w, light.half_v), dot(w, light.half_u));
    phi = phi < 0.0 ? phi + 2.0 * pi : phi;

    float last = texelFetch(light_table, first_gamma + gammas - 1).x;
    const float slack = 1e-5; // π as the file printed it [rad]
    if (gamma < texelFetch(light_table, first_gamma).x - slack || gamma > last + slack) return 0.0;
    vec2 row = interval_of(gamma, first_gamma, gammas);
    vec2 column = interval_of(phi, first_phi, int(header.y));
    int corner = first_I + int(column.x) * gammas + int(row.x);
    float here = mix(texelFetch(light_table, corner).x, texelFetch(light_table, corner + 1).x, row.y);
    float next = mix(texelFetch(light_table, corner + gammas).x, texelFetch(light_table, corner + gammas + 1).x, row.y);
    return mix(here, next, column.y);
}
