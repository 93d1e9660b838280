// solution by_a_sum
float flux(float I_0, float m) {
    float sum = 0.0, d_theta = 0.5 * pi / 256.0;
    for (int i = 0; i < 256; ++i) {
        float theta = (float(i) + 0.5) * d_theta;
        sum += I(theta, I_0, m) * sin(theta) * d_theta;
    }
    return 2.0 * pi * sum;
}
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity * pow(r, -2.0); }
// solution over_the_sphere
float flux(float I_0, float m) {
    float sum = 0.0;
    for (int i = 0; i < 500; ++i) {
        float theta = (float(i) + 0.5) * pi / 500.0;
        sum += I(theta, I_0, m) * sin(theta);
    }
    return sum * (pi / 500.0) * (pi + pi);
}
float flux_of_your_lamp() { return 2.0 * pi / (1.0 + lamp_exponent) * lamp_intensity; }
float E_facing(float intensity, float r) { return intensity / r / r; }
// mistake sine_missing
float flux(float I_0, float m) {
    float sum = 0.0, d_theta = 0.5 * pi / 256.0;
    for (int i = 0; i < 256; ++i) sum += I((float(i) + 0.5) * d_theta, I_0, m) * d_theta;
    return 2.0 * pi * sum;
}
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (r * r); }
// mistake same_in_all_directions
float flux(float I_0, float m) { return 4.0 * pi * I_0; }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (r * r); }
// mistake both_halves
float flux(float I_0, float m) { return 4.0 * pi * I_0 / (m + 1.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (r * r); }
// mistake turn_missing
float flux(float I_0, float m) { return I_0 / (m + 1.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (r * r); }
// mistake half_turn
float flux(float I_0, float m) { return pi * I_0 / (m + 1.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (r * r); }
// mistake one_more_cosine
float flux(float I_0, float m) { return 2.0 * pi * I_0 / (m + 2.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (r * r); }
// mistake not_squared
float flux(float I_0, float m) { return 2.0 * pi * I_0 / (m + 1.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / r; }
// mistake over_the_sphere_again
float flux(float I_0, float m) { return 2.0 * pi * I_0 / (m + 1.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (4.0 * pi * r * r); }
// mistake distance_missing
float flux(float I_0, float m) { return 2.0 * pi * I_0 / (m + 1.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity; }
// mistake cubed
float flux(float I_0, float m) { return 2.0 * pi * I_0 / (m + 1.0); }
float flux_of_your_lamp() { return flux(lamp_intensity, lamp_exponent); }
float E_facing(float intensity, float r) { return intensity / (r * r * r); }
