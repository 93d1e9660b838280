// solution by_the_height
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return d_phi * cos(theta_0) - d_phi * cos(theta_1); }
float omega_of_cone(float alpha) { return omega_of_patch(0.0, alpha, 2.0 * pi); }
// solution by_a_sum
float d_omega(float theta, float d_theta, float d_phi) { return d_phi * d_theta * cos(0.5 * pi - theta); }
float omega_of_patch(float theta_0, float theta_1, float d_phi) {
    float sum = 0.0, step = (theta_1 - theta_0) / 400.0;
    for (int i = 0; i < 400; ++i) sum += d_omega(theta_0 + (float(i) + 0.5) * step, step, d_phi);
    return sum;
}
float omega_of_cone(float alpha) {
    float h = 1.0 - cos(alpha); // of the cap on the unit sphere
    return 2.0 * pi * h;
}
// mistake sine_missing
float d_omega(float theta, float d_theta, float d_phi) { return d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (theta_1 - theta_0) * d_phi; }
float omega_of_cone(float alpha) { return 2.0 * pi * alpha; }
// mistake cosine_for_sine
float d_omega(float theta, float d_theta, float d_phi) { return cos(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (sin(theta_1) - sin(theta_0)) * d_phi; }
float omega_of_cone(float alpha) { return 2.0 * pi * sin(alpha); }
// mistake degrees
float d_omega(float theta, float d_theta, float d_phi) { return sin(radians(theta)) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (cos(radians(theta_0)) - cos(radians(theta_1))) * d_phi; }
float omega_of_cone(float alpha) { return 2.0 * pi * (1.0 - cos(radians(alpha))); }
// mistake limits_swapped
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (cos(theta_1) - cos(theta_0)) * d_phi; }
float omega_of_cone(float alpha) { return 2.0 * pi * (1.0 - cos(alpha)); }
// mistake sine_of_the_middle
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return sin(0.5 * (theta_0 + theta_1)) * (theta_1 - theta_0) * d_phi; }
float omega_of_cone(float alpha) { return 2.0 * pi * (1.0 - cos(alpha)); }
// mistake projected_cone
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (cos(theta_0) - cos(theta_1)) * d_phi; }
float omega_of_cone(float alpha) { return pi * sin(alpha) * sin(alpha); }
// mistake flat_disk
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (cos(theta_0) - cos(theta_1)) * d_phi; }
float omega_of_cone(float alpha) { return pi * alpha * alpha; }
// mistake full_opening
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (cos(theta_0) - cos(theta_1)) * d_phi; }
float omega_of_cone(float alpha) { return 2.0 * pi * (1.0 - cos(0.5 * alpha)); }
// mistake cone_of_4_pi
float d_omega(float theta, float d_theta, float d_phi) { return sin(theta) * d_theta * d_phi; }
float omega_of_patch(float theta_0, float theta_1, float d_phi) { return (cos(theta_0) - cos(theta_1)) * d_phi; }
float omega_of_cone(float alpha) { return 4.0 * pi * (1.0 - cos(alpha)); }
