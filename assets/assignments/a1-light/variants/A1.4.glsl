// solution by_the_radius
vec3 direction(float theta, float phi) { return vec3(sin(theta) * vec2(cos(phi), sin(phi)), cos(theta)); }
vec2 angles(vec3 w) { return vec2(atan(length(w.xy), w.z), atan(w.y, w.x)); }
// solution from_zero_to_two_pi
vec3 direction(float theta, float phi) {
    float r = sqrt(max(0.0, 1.0 - cos(theta) * cos(theta)));
    return vec3(r * cos(phi), r * sin(phi), cos(theta));
}
vec2 angles(vec3 w) {
    float phi = acos(clamp(w.x / length(w.xy), -1.0, 1.0));
    return vec2(0.5 * pi - asin(clamp(w.z, -1.0, 1.0)), w.y < 0.0 ? 2.0 * pi - phi : phi);
}
// mistake theta_from_the_horizon
vec3 direction(float theta, float phi) { return vec3(cos(theta) * cos(phi), cos(theta) * sin(phi), sin(theta)); }
vec2 angles(vec3 w) { return vec2(asin(clamp(w.z, -1.0, 1.0)), atan(w.y, w.x)); }
// mistake y_up
vec3 direction(float theta, float phi) { return vec3(sin(theta) * cos(phi), cos(theta), sin(theta) * sin(phi)); }
vec2 angles(vec3 w) { return vec2(acos(clamp(w.y, -1.0, 1.0)), atan(w.z, w.x)); }
// mistake x_and_y_swapped
vec3 direction(float theta, float phi) { return vec3(sin(theta) * sin(phi), sin(theta) * cos(phi), cos(theta)); }
vec2 angles(vec3 w) { return vec2(acos(clamp(w.z, -1.0, 1.0)), atan(w.x, w.y)); }
// mistake degrees
vec3 direction(float theta, float phi) { return vec3(sin(radians(theta)) * cos(radians(phi)), sin(radians(theta)) * sin(radians(phi)), cos(radians(theta))); }
vec2 angles(vec3 w) { return vec2(degrees(acos(clamp(w.z, -1.0, 1.0))), degrees(atan(w.y, w.x))); }
// mistake sine_missing
vec3 direction(float theta, float phi) { return vec3(cos(phi), sin(phi), cos(theta)); }
vec2 angles(vec3 w) { return vec2(acos(clamp(w.z, -1.0, 1.0)), atan(w.y, w.x)); }
// mistake half_the_turn
vec3 direction(float theta, float phi) { return vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)); }
vec2 angles(vec3 w) { return vec2(acos(clamp(w.z, -1.0, 1.0)), atan(w.y / w.x)); }
// mistake half_the_sphere
vec3 direction(float theta, float phi) { return vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)); }
vec2 angles(vec3 w) { return vec2(asin(clamp(length(w.xy), 0.0, 1.0)), atan(w.y, w.x)); }
// mistake phi_first
vec3 direction(float theta, float phi) { return vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)); }
vec2 angles(vec3 w) { return vec2(atan(w.y, w.x), acos(clamp(w.z, -1.0, 1.0))); }
