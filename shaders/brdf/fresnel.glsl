// Schlick's approximation of the Fresnel reflectance.
//
//   F = F0 + (1 - F0) (1 - w·h)⁵
//
// Schlick 1994, Eq. 15.

float schlick_weight(float cos_h) {
    float m = clamp(1.0 - cos_h, 0.0, 1.0);
    float m2 = m * m;
    return m2 * m2 * m;
}

vec3 F_schlick(vec3 F0, float cos_h) { return F0 + (1.0 - F0) * schlick_weight(cos_h); }
