// The reflectance of a conductor of index n + ik, by Fresnel's equations, without polarisation.
//
//   F = (R_s + R_p)/2,    R_s = (A - 2ac + c²)/(A + 2ac + c²),    R_p = R_s (Ac² - 2acs² + s⁴)/(Ac² + 2acs² + s⁴)
//
//   c = cosθ, s = sinθ,    A = a² + b² = √((n² - k² - s²)² + 4n²k²),    a² = (A + n² - k² - s²)/2
//
// Born & Wolf 1999, "Principles of Optics", section 14.2. Limit: n and k stand for a band of wavelengths each; those of metals
// are fitted to the spectral reflectance (src/scene/conductor.hpp).

vec3 F_conductor(vec3 n, vec3 k, float c) {
    float s2 = 1.0 - c * c;
    vec3 t = n * n - k * k - s2;
    vec3 A = sqrt(t * t + 4.0 * n * n * k * k);
    vec3 ac2 = 2.0 * c * sqrt(max(0.5 * (A + t), vec3(0.0)));
    vec3 R_s = (A - ac2 + c * c) / (A + ac2 + c * c);
    vec3 R_p = R_s * (A * c * c - ac2 * s2 + s2 * s2) / (A * c * c + ac2 * s2 + s2 * s2);
    return 0.5 * (R_s + R_p);
}
