// solution by_two_turns
vec3 turned_around_n(vec3 w, float a) { return vec3(cos(a) * w.x - sin(a) * w.y, sin(a) * w.x + cos(a) * w.y, w.z); }
vec3 turned_around_b(vec3 w, float a) { return vec3(cos(a) * w.x + sin(a) * w.z, w.y, cos(a) * w.z - sin(a) * w.x); }
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    float theta_h = acos(clamp(h.z, -1.0, 1.0)), phi_h = atan(h.y, h.x);
    vec3 d = turned_around_b(turned_around_n(wi, -phi_h), -theta_h);
    return vec3(theta_h, acos(clamp(d.z, -1.0, 1.0)), atan(d.y, d.x));
}
vec3 place_in_table(vec3 angles) {
    float phi = angles.z;
    if (phi < 0.0) phi += pi;
    return vec3(sqrt(degrees(angles.x) * 90.0), degrees(angles.y), degrees(phi));
}
// solution by_a_matrix
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(0.5 * (wi + wo));
    float r = length(h.xy);
    vec2 e = r > 0.0 ? h.xy / r : vec2(1.0, 0.0);
    vec3 d = vec3(h.z * dot(e, wi.xy) - r * wi.z, e.x * wi.y - e.y * wi.x, dot(wi, h));
    return vec3(atan(r, h.z), atan(length(d.xy), d.z), atan(d.y, d.x));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0, 90.0, 180.0) * vec3(sqrt(angles.x / (0.5 * pi)), angles.y / (0.5 * pi), mod(angles.z, pi) / pi);
}
// mistake half_not_normalised
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = wi + wo;
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, h), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t)));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake half_of_the_difference
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi - wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, h), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t)));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake turned_the_wrong_way
vec3 turned_around_n(vec3 w, float a) { return vec3(cos(a) * w.x - sin(a) * w.y, sin(a) * w.x + cos(a) * w.y, w.z); }
vec3 turned_around_b(vec3 w, float a) { return vec3(cos(a) * w.x + sin(a) * w.z, w.y, cos(a) * w.z - sin(a) * w.x); }
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    float theta_h = acos(clamp(h.z, -1.0, 1.0)), phi_h = atan(h.y, h.x);
    vec3 d = turned_around_b(turned_around_n(wi, phi_h), theta_h);
    return vec3(theta_h, acos(clamp(d.z, -1.0, 1.0)), atan(d.y, d.x));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake turns_swapped
vec3 turned_around_n(vec3 w, float a) { return vec3(cos(a) * w.x - sin(a) * w.y, sin(a) * w.x + cos(a) * w.y, w.z); }
vec3 turned_around_b(vec3 w, float a) { return vec3(cos(a) * w.x + sin(a) * w.z, w.y, cos(a) * w.z - sin(a) * w.x); }
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    float theta_h = acos(clamp(h.z, -1.0, 1.0)), phi_h = atan(h.y, h.x);
    vec3 d = turned_around_n(turned_around_b(wi, -theta_h), -phi_h);
    return vec3(theta_h, acos(clamp(d.z, -1.0, 1.0)), atan(d.y, d.x));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake not_turned_around_n
vec3 turned_around_n(vec3 w, float a) { return vec3(cos(a) * w.x - sin(a) * w.y, sin(a) * w.x + cos(a) * w.y, w.z); }
vec3 turned_around_b(vec3 w, float a) { return vec3(cos(a) * w.x + sin(a) * w.z, w.y, cos(a) * w.z - sin(a) * w.x); }
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    float theta_h = acos(clamp(h.z, -1.0, 1.0)), phi_h = atan(h.y, h.x);
    vec3 d = turned_around_b(wi, -theta_h);
    return vec3(theta_h, acos(clamp(d.z, -1.0, 1.0)), atan(d.y, d.x));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake not_turned
vec3 turned_around_n(vec3 w, float a) { return vec3(cos(a) * w.x - sin(a) * w.y, sin(a) * w.x + cos(a) * w.y, w.z); }
vec3 turned_around_b(vec3 w, float a) { return vec3(cos(a) * w.x + sin(a) * w.z, w.y, cos(a) * w.z - sin(a) * w.x); }
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    float theta_h = acos(clamp(h.z, -1.0, 1.0)), phi_h = atan(h.y, h.x);
    vec3 d = wi;
    return vec3(theta_h, acos(clamp(d.z, -1.0, 1.0)), atan(d.y, d.x));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake wo_for_wi
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wo, h), -1.0, 1.0)), atan(dot(wo, b), dot(wo, t)));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake whole_angle_between
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, wo), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t)));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake degrees
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return degrees(vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, h), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t))));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(angles.x / 90.0), angles.y, 180.0 * fract(angles.z / 180.0));
}
// mistake root_missing
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, h), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t)));
}
vec3 place_in_table(vec3 angles) {
    return vec3(180.0 * angles.x / pi, 180.0 * angles.y / pi, 180.0 * fract(angles.z / pi));
}
// mistake whole_turn
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, h), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t)));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * fract(0.5 * angles.z / pi));
}
// mistake negative_angles_stay
vec3 half_and_difference(vec3 wi, vec3 wo) {
    vec3 h = normalize(wi + wo);
    vec3 b = length(h.xy) > 0.0 ? vec3(-h.y, h.x, 0.0) / length(h.xy) : vec3(0.0, 1.0, 0.0);
    vec3 t = cross(b, h);
    return vec3(acos(clamp(h.z, -1.0, 1.0)), acos(clamp(dot(wi, h), -1.0, 1.0)), atan(dot(wi, b), dot(wi, t)));
}
vec3 place_in_table(vec3 angles) {
    return vec3(90.0 * sqrt(2.0 * angles.x / pi), 180.0 * angles.y / pi, 180.0 * angles.z / pi);
}
