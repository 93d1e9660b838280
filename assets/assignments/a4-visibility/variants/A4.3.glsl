// solution by_its_length
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    return x + (dot(n, w) >= 0.0 ? n : -n) * (length(x) / 65536.0);
}
// solution in_units_of_the_last_place
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    float reach = largest_coordinate(x);
    float unit = uintBitsToFloat(floatBitsToUint(reach) + 1u) - reach; // of the last place
    return x + sign(dot(n, w)) * 200.0 * unit * n;
}
// mistake no_offset
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) { return x; }
// mistake fixed_length
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    float side = dot(n, w) < 0.0 ? -1.0 : 1.0;
    return x + side * 1e-6 * n;
}
// mistake too_far
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    float side = dot(n, w) < 0.0 ? -1.0 : 1.0;
    return x + side * 0.01 * n;
}
// mistake along_w
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) { return x + exp2(-16.0) * largest_coordinate(x) * normalize(w); }
// mistake always_along_n
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    float side = dot(n, w) < 0.0 ? -1.0 : 1.0;
    return x + exp2(-16.0) * largest_coordinate(x) * n;
}
// mistake other_side
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    float side = dot(n, w) > 0.0 ? -1.0 : 1.0;
    return x + side * exp2(-16.0) * largest_coordinate(x) * n;
}
// mistake x_scaled
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) { return x * (1.0 + exp2(-16.0)); }
// mistake one_coordinate
vec3 shadow_origin(vec3 x, vec3 n, vec3 w) {
    float side = dot(n, w) < 0.0 ? -1.0 : 1.0;
    return x + side * exp2(-16.0) * x.z * n;
}
