// solution without_cancellation
float height_of_cap(vec3 x, vec3 c, float R) {
    float sin2 = R * R / dot(c - x, c - x);
    return sin2 / (1.0 + sqrt(1.0 - sin2));
}
float p_cone(vec3 x, vec3 c, float R) { return 0.5 / (pi * height_of_cap(x, c, R)); }
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float h = u.x * height_of_cap(x, c, R);
    float s = sqrt(h * (2.0 - h));
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), 1.0 - h);
}
// solution other_frame
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    vec3 w = normalize(c - x);
    vec3 t = normalize(cross(w, abs(w.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    float cos_max = cos(asin(R / distance(x, c)));
    float z = mix(cos_max, 1.0, u.y);
    float phi = 6.2831853 * u.x;
    return z * w + sqrt(1.0 - z * z) * (cos(phi) * t + sin(phi) * cross(w, t));
}
// mistake tangent_for_sine
float p_cone(vec3 x, vec3 c, float R) {
    float d = length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - d / sqrt(d * d + R * R)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float d = length(c - x);
    float z = 1.0 - u.x * (1.0 - d / sqrt(d * d + R * R));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}
// mistake sine_not_squared
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float z = 1.0 - u.x * (1.0 - sqrt(1.0 - sin_max));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}
// mistake two_pi_missing
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / ((1.0 - sqrt(1.0 - sin_max * sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float z = 1.0 - u.x * (1.0 - sqrt(1.0 - sin_max * sin_max));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}
// mistake solid_angle_for_density
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float z = 1.0 - u.x * (1.0 - sqrt(1.0 - sin_max * sin_max));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}
// mistake disk_for_cap
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (pi * sin_max * sin_max);
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float z = 1.0 - u.x * (1.0 - sqrt(1.0 - sin_max * sin_max));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}
// mistake even_in_the_angle
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float theta = u.x * asin(R / length(c - x));
    float s = sin(theta);
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), cos(theta));
}
// mistake hemisphere_for_cone
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float s = sqrt(1.0 - u.x * u.x);
    return frame_around(normalize(c - x)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), u.x);
}
// mistake around_the_z_axis
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float z = 1.0 - u.x * (1.0 - sqrt(1.0 - sin_max * sin_max));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}
// mistake away_from_the_sphere
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float z = 1.0 - u.x * (1.0 - sqrt(1.0 - sin_max * sin_max));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(x - c)) * vec3(s * cos(2.0 * pi * u.y), s * sin(2.0 * pi * u.y), z);
}
// mistake phi_without_2_pi
float p_cone(vec3 x, vec3 c, float R) {
    float sin_max = R / length(c - x);
    return 1.0 / (2.0 * pi * (1.0 - sqrt(1.0 - sin_max * sin_max)));
}
vec3 direction_in_cone(vec3 x, vec3 c, float R, vec2 u) {
    float sin_max = R / length(c - x);
    float z = 1.0 - u.x * (1.0 - sqrt(1.0 - sin_max * sin_max));
    float s = sqrt(max(0.0, 1.0 - z * z));
    return frame_around(normalize(c - x)) * vec3(s * cos(u.y), s * sin(u.y), z);
}
