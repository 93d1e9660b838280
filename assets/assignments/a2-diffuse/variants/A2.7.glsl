// solution channel_by_channel
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    vec3 E;
    for (int c = 0; c < 3; ++c) {
        if (lamp.kind == point_lamp) E[c] = E_point(x, n, lamp.position, lamp.quantity[c]);
        if (lamp.kind == spot_lamp)
            E[c] = E_spot(x, n, lamp.position, lamp.quantity[c], lamp.axis, lamp.cos_inner, lamp.cos_outer);
        if (lamp.kind == directional_lamp) E[c] = E_directional(n, lamp.axis, lamp.quantity[c]);
    }
    return E;
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return f_diffuse(rho) * E + L_e; }
// solution by_the_spot
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return E_directional(n, lamp.axis, 1.0) * lamp.quantity;
    vec3 w = normalize(x - lamp.position);
    float s = lamp.kind == spot_lamp ? spot_intensity(1.0, lamp.axis, w, lamp.cos_inner, lamp.cos_outer) : 1.0;
    return s * E_point(x, n, lamp.position, 1.0) * lamp.quantity;
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return (pi * L_e + rho * E) / pi; }
// mistake all_as_points
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e + L_r(rho, E); }
// mistake spots_as_points
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e + L_r(rho, E); }
// mistake color_missing
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return vec3(lamp.quantity.r) * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return vec3(lamp.quantity.r) * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return vec3(lamp.quantity.r) * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e + L_r(rho, E); }
// mistake inner_and_outer_swapped
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_outer, lamp.cos_inner);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e + L_r(rho, E); }
// mistake emission_missing
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_r(rho, E); }
// mistake reflection_missing
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e; }
// mistake emission_tinted
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return rho * L_e + L_r(rho, E); }
// mistake emission_reflected
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_r(rho, E + L_e); }
// mistake irradiance_for_radiance
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e + E; }
// mistake pi_missing
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e + rho * E; }
// mistake multiplied
vec3 E_of_lamp(Lamp lamp, vec3 x, vec3 n) {
    if (lamp.kind == directional_lamp) return lamp.quantity * E_directional(n, lamp.axis, 1.0);
    if (lamp.kind == spot_lamp)
        return lamp.quantity * E_spot(x, n, lamp.position, 1.0, lamp.axis, lamp.cos_inner, lamp.cos_outer);
    return lamp.quantity * E_point(x, n, lamp.position, 1.0);
}
vec3 L_o(vec3 L_e, vec3 rho, vec3 E) { return L_e * L_r(rho, E); }
