// solution by_the_reciprocal
vec3 f_diffuse(vec3 rho) { return 0.318309886 * rho; }
vec3 L_r(vec3 rho, vec3 E) { return rho * E / pi; }
vec3 exitance(vec3 L) { return L * radians(180.0); }
// solution channel_by_channel
vec3 f_diffuse(vec3 rho) { return vec3(rho.r / pi, rho.g / pi, rho.b / pi); }
vec3 L_r(vec3 rho, vec3 E) { return E * f_diffuse(rho); }
vec3 exitance(vec3 L) { return L * (4.0 * atan(1.0)); }
// mistake albedo_alone
vec3 f_diffuse(vec3 rho) { return rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return rho * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake pi_missing
vec3 f_diffuse(vec3 rho) { return rho; }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake times_pi
vec3 f_diffuse(vec3 rho) { return rho * pi; }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake over_2_pi
vec3 f_diffuse(vec3 rho) { return rho / (2.0 * pi); }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake over_4_pi
vec3 f_diffuse(vec3 rho) { return rho / (4.0 * pi); }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake albedo_squared
vec3 f_diffuse(vec3 rho) { return rho * rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake one_channel
vec3 f_diffuse(vec3 rho) { return vec3(rho.r / pi); }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake albedo_twice
vec3 f_diffuse(vec3 rho) { return rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return rho * f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake pi_twice
vec3 f_diffuse(vec3 rho) { return rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E / pi; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake brdf_missing
vec3 f_diffuse(vec3 rho) { return rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return E; }
vec3 exitance(vec3 L) { return pi * L; }
// mistake exitance_of_2_pi
vec3 f_diffuse(vec3 rho) { return rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return 2.0 * pi * L; }
// mistake exitance_of_4_pi
vec3 f_diffuse(vec3 rho) { return rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return 4.0 * pi * L; }
// mistake exitance_without_pi
vec3 f_diffuse(vec3 rho) { return rho / pi; }
vec3 L_r(vec3 rho, vec3 E) { return f_diffuse(rho) * E; }
vec3 exitance(vec3 L) { return L; }
