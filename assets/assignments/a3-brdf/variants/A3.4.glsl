// solution by_pow
vec3 F(float cos_d, vec3 F0) { return mix(F0, vec3(1.0), pow(1.0 - cos_d, 5.0)); }
// solution grouped
vec3 F(float cos_d, vec3 F0) {
    float c = 1.0 - cos_d;
    float c5 = c * c * c * c * c;
    return c5 + F0 * (1.0 - c5);
}
// mistake cosine_for_one_minus_cosine
vec3 F(float cos_d, vec3 F0) { return F0 + (1.0 - F0) * pow(cos_d, 5.0); }
// mistake fourth_power
vec3 F(float cos_d, vec3 F0) { return F0 + (1.0 - F0) * pow(1.0 - cos_d, 4.0); }
// mistake added_whole
vec3 F(float cos_d, vec3 F0) { return F0 + pow(1.0 - cos_d, 5.0); }
// mistake F0_missing
vec3 F(float cos_d, vec3 F0) { return (1.0 - F0) * pow(1.0 - cos_d, 5.0); }
// mistake transmitted
vec3 F(float cos_d, vec3 F0) { return 1.0 - (F0 + (1.0 - F0) * pow(1.0 - cos_d, 5.0)); }
// mistake one_channel
vec3 F(float cos_d, vec3 F0) { return vec3(F0.x + (1.0 - F0.x) * pow(1.0 - cos_d, 5.0)); }
