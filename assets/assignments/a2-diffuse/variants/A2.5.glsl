// solution by_the_half_angle
float intensity_of_point(float Phi) { return 0.25 * Phi / pi; }
float intensity_of_cone(float Phi, float alpha) { return Phi / (4.0 * pi * pow(sin(0.5 * alpha), 2.0)); }
float radiance_of_panel(float Phi, float A) { return Phi / A / pi; }
float radiance_of_your_wall() { return wall_albedo * bulb_flux / (4.0 * pi * pi * bulb_distance * bulb_distance); }
// solution by_the_sphere
float intensity_of_point(float Phi) { return Phi / 4.0 / pi; }
float intensity_of_cone(float Phi, float alpha) { return Phi / (pi + pi) / (1.0 - cos(alpha)); }
float radiance_of_panel(float Phi, float A) { return (Phi / A) * 0.318309886; }
float radiance_of_your_wall() { return radiance_of_panel(wall_albedo * bulb_flux, 4.0 * pi * bulb_distance * bulb_distance); }
// mistake wall_lit_by_flux
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * bulb_flux / (bulb_distance * bulb_distance); }
// mistake hemisphere
float intensity_of_point(float Phi) { return Phi / (2.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake over_pi
float intensity_of_point(float Phi) { return Phi / pi; }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake solid_angle_missing
float intensity_of_point(float Phi) { return Phi; }
float intensity_of_cone(float Phi, float alpha) { return Phi; }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake cone_of_the_sphere
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (4.0 * pi); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake flat_cone
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (pi * alpha * alpha); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake projected_cone
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (pi * pow(sin(alpha), 2.0)); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake full_opening
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(0.5 * alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake panel_without_pi
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / A; }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake panel_over_2_pi
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (2.0 * pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake panel_times_pi
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return pi * Phi / A; }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake wall_without_pi
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo * intensity_of_point(bulb_flux) / (bulb_distance * bulb_distance); }
// mistake wall_not_squared
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return wall_albedo / pi * intensity_of_point(bulb_flux) / bulb_distance; }
// mistake wall_without_albedo
float intensity_of_point(float Phi) { return Phi / (4.0 * pi); }
float intensity_of_cone(float Phi, float alpha) { return Phi / (2.0 * pi * (1.0 - cos(alpha))); }
float radiance_of_panel(float Phi, float A) { return Phi / (pi * A); }
float radiance_of_your_wall() { return intensity_of_point(bulb_flux) / (pi * bulb_distance * bulb_distance); }
