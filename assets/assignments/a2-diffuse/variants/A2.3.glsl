// solution towards_the_light
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return max(dot(-direction, n), 0.0) * E_perpendicular; }
// solution by_the_difference
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return E_perpendicular * max(0.0, 0.5 * dot(n - direction, n - direction) - 1.0); }
// mistake direction_reversed
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return E_perpendicular * max(0.0, dot(n, direction)); }
// mistake cosine_not_clamped
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return -E_perpendicular * dot(n, direction); }
// mistake absolute_cosine
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return E_perpendicular * abs(dot(n, direction)); }
// mistake cosine_missing
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return E_perpendicular; }
// mistake sine
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return dot(n, direction) < 0.0 ? E_perpendicular * length(cross(n, direction)) : 0.0; }
// mistake wrapped
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return E_perpendicular * (0.5 - 0.5 * dot(n, direction)); }
// mistake over_pi
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return E_perpendicular * max(0.0, -dot(n, direction)) / pi; }
// mistake cosine_squared
float E_directional(vec3 n, vec3 direction, float E_perpendicular) { return E_perpendicular * pow(max(0.0, -dot(n, direction)), 2.0); }
