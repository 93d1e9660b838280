// solution by_solid_angles
float radiance(float Phi, float A, float cos_theta, float omega) {
    float E = Phi / A;
    return E / omega / cos_theta;
}
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) {
    float omega_2 = A_2 * cos_2 / (r * r); // of the second area, seen from the first
    return L * A_1 * cos_1 * omega_2;
}
// solution by_the_receiver
float radiance(float Phi, float A, float cos_theta, float omega) {
    float intensity = Phi / omega;
    float seen_area = A * cos_theta;
    return intensity / seen_area;
}
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) {
    float E = L * (A_1 * cos_1 / r / r) * cos_2; // on the second area
    return E * A_2;
}
// mistake cosine_missing
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (A * omega); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * A_2 / (r * r); }
// mistake cosine_times
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi * cos_theta / (A * omega); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 * cos_2 / (r * r); }
// mistake solid_angle_missing
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (A * cos_theta); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 * cos_2 / (r * r); }
// mistake area_missing
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (cos_theta * omega); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 * cos_2 / (r * r); }
// mistake over_pi
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (pi * A); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 * cos_2 / (r * r); }
// mistake one_cosine
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (A * cos_theta * omega); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 / (r * r); }
// mistake not_squared
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (A * cos_theta * omega); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 * cos_2 / r; }
// mistake distance_missing
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (A * cos_theta * omega); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 * cos_2; }
// mistake over_4_pi
float radiance(float Phi, float A, float cos_theta, float omega) { return Phi / (A * cos_theta * omega); }
float flux_between(float L, float A_1, float cos_1, float A_2, float cos_2, float r) { return L * A_1 * cos_1 * A_2 * cos_2 / (4.0 * pi * r * r); }
