// solution channel_by_channel
vec3 exposed(vec3 L, float EV100) { return L * pow(2.0, -EV100) / 1.2; }
float encoded_channel(float v) {
    if (v <= 0.0) return 0.0;
    if (v >= 1.0) return 1.0;
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}
vec3 encoded(vec3 v) { return vec3(encoded_channel(v.r), encoded_channel(v.g), encoded_channel(v.b)); }
float decoded_channel(float s) { return s <= 0.04045 ? s / 12.92 : pow((s + 0.055) / 1.055, 2.4); }
vec3 decoded(vec3 s) { return vec3(decoded_channel(s.r), decoded_channel(s.g), decoded_channel(s.b)); }
float code_value_of_your_wall() { return 255.0 * encoded_channel(radiance_of_your_wall() * exp2(-camera_EV) / 1.2); }
// solution by_logarithms
vec3 exposed(vec3 L, float EV100) { return L * exp2(-EV100 - log2(1.2)); }
vec3 encoded(vec3 v) {
    vec3 c = min(max(v, vec3(0.0)), vec3(1.0));
    vec3 root = exp2(log2(max(c, vec3(1e-6))) * 5.0 / 12.0);
    return mix(c * 12.92, root * 1.055 - 0.055, greaterThan(c, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    vec3 power = exp2(log2(s / 1.055 + 0.055 / 1.055) * 2.4);
    return mix(s / 12.92, power, greaterThan(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).g; }
// mistake wall_not_encoded
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * exposed(vec3(radiance_of_your_wall()), camera_EV).r; }
// mistake wall_not_exposed
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * encoded(vec3(radiance_of_your_wall())).r; }
// mistake factor_1_2_missing
vec3 exposed(vec3 L, float EV100) { return L / exp2(EV100); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake times_for_over
vec3 exposed(vec3 L, float EV100) { return L * 1.2 * exp2(EV100); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake exponent_for_power
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * EV100); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake power_of_e
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp(EV100)); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake power_of_2_2
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    return pow(clamp(v, 0.0, 1.0), vec3(1.0 / 2.2));
}
vec3 decoded(vec3 s) {
    return pow(s, vec3(2.2));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake linear_part_missing
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    return 1.055 * pow(clamp(v, 0.0, 1.0), vec3(1.0 / 2.4)) - 0.055;
}
vec3 decoded(vec3 s) {
    return pow((s + 0.055) / 1.055, vec3(2.4));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake wrong_way
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(pow((max(v, 0.04045) + 0.055) / 1.055, vec3(2.4)), v / 12.92, lessThanEqual(v, vec3(0.04045)));
}
vec3 decoded(vec3 s) {
    return mix(1.055 * pow(max(s, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * s, lessThanEqual(s, vec3(0.0031308)));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake not_clamped
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake not_encoded
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    return clamp(v, 0.0, 1.0);
}
vec3 decoded(vec3 s) {
    return s;
}
float code_value_of_your_wall() { return 255.0 * encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
// mistake wall_of_0_to_1
vec3 exposed(vec3 L, float EV100) { return L / (1.2 * exp2(EV100)); }
vec3 encoded(vec3 v) {
    v = clamp(v, 0.0, 1.0);
    return mix(1.055 * pow(max(v, 0.0031308), vec3(1.0 / 2.4)) - 0.055, 12.92 * v, lessThanEqual(v, vec3(0.0031308)));
}
vec3 decoded(vec3 s) {
    return mix(pow((max(s, 0.04045) + 0.055) / 1.055, vec3(2.4)), s / 12.92, lessThanEqual(s, vec3(0.04045)));
}
float code_value_of_your_wall() { return encoded(exposed(vec3(radiance_of_your_wall()), camera_EV)).r; }
