// solution edges_exchanged
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    vec3 ex = normalize(r.edge_v), ey = normalize(r.edge_u), ez = cross(ex, ey);
    vec3 corner = r.corner - x;
    if (dot(corner, ez) > 0.0) ez = -ez;
    float z = dot(corner, ez);
    vec2 low = vec2(dot(corner, ex), dot(corner, ey));
    vec2 high = low + vec2(length(r.edge_v), length(r.edge_u));
    float b0 = -low.y / length(vec2(z, low.y)), b1 = high.y / length(vec2(z, high.y));
    float g2 = atan(-z * length(vec3(low.x, high.y, z)), low.x * high.y);
    float g3 = atan(-z * length(vec3(low, z)), -low.x * low.y);
    float turn = u.x * solid_angle(r, x) - g2 - g3;
    vec2 f = vec2(cos(turn) * b0 - b1, sin(turn) * b0);
    float cu = sign(f.x) * sin(turn) / length(f);
    float s = clamp(-cu * z / sqrt(max(1.0 - cu * cu, 1e-12)), low.x, high.x);
    float d2 = s * s + z * z;
    float h = mix(low.y / sqrt(d2 + low.y * low.y), high.y / sqrt(d2 + high.y * high.y), u.y);
    return normalize(s * ex + h * sqrt(d2 / (1.0 - h * h)) * ey + z * ez);
}
// solution by_bisection
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    float low = 0.0, high = 1.0;
    float wanted = u.x * solid_angle(r, x);
    for (int i = 0; i < 22; ++i) {
        float middle = 0.5 * (low + high);
        if (solid_angle(Rectangle(r.corner, middle * r.edge_u, r.edge_v), x) < wanted)
            low = middle;
        else
            high = middle;
    }
    vec3 begin = r.corner + low * r.edge_u - x, end = begin + r.edge_v; // the line with the density of h even along it
    vec3 along = normalize(r.edge_v);
    float h = mix(dot(normalize(begin), along), dot(normalize(end), along), u.y);
    vec3 across = normalize(begin - dot(begin, along) * along);
    return h * along + sqrt(1.0 - h * h) * across;
}
// mistake over_the_area
vec3 direction_to(Rectangle r, vec3 x, vec2 u) { return normalize(point_on(r, u) - x); }
// mistake corner_directions_mixed
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    vec3 a = normalize(r.corner - x), b = normalize(r.corner + r.edge_u - x);
    vec3 c = normalize(r.corner + r.edge_u + r.edge_v - x), d = normalize(r.corner + r.edge_v - x);
    return normalize(mix(mix(a, b, u.x), mix(d, c, u.x), u.y));
}
// mistake not_unit
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    vec3 ex = normalize(r.edge_u), ey = normalize(r.edge_v), ez = cross(ex, ey);
    vec3 corner = r.corner - x;
    if (dot(corner, ez) > 0.0) ez = -ez;
    float z = dot(corner, ez);
    vec2 low = vec2(dot(corner, ex), dot(corner, ey));
    vec2 high = low + vec2(length(r.edge_u), length(r.edge_v));
    float b0 = -low.y / length(vec2(z, low.y)), b1 = high.y / length(vec2(z, high.y));
    float g2 = atan(-z * length(vec3(low.x, high.y, z)), low.x * high.y);
    float g3 = atan(-z * length(vec3(low, z)), -low.x * low.y);
    float turn = u.x * solid_angle(r, x) - g2 - g3;
    float f = (cos(turn) * b0 - b1) / sin(turn);
    float cu = sign(f) / sqrt(f * f + b0 * b0);
    float s = clamp(-cu * z / sqrt(max(1.0 - cu * cu, 1e-12)), low.x, high.x);
    float d2 = s * s + z * z;
    float h = mix(low.y / sqrt(d2 + low.y * low.y), high.y / sqrt(d2 + high.y * high.y), u.y);
    return s * ex + h * sqrt(d2 / (1.0 - h * h)) * ey + z * ez;
}
// mistake second_step_by_length
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    vec3 ex = normalize(r.edge_u), ey = normalize(r.edge_v), ez = cross(ex, ey);
    vec3 corner = r.corner - x;
    if (dot(corner, ez) > 0.0) ez = -ez;
    float z = dot(corner, ez);
    vec2 low = vec2(dot(corner, ex), dot(corner, ey));
    vec2 high = low + vec2(length(r.edge_u), length(r.edge_v));
    float b0 = -low.y / length(vec2(z, low.y)), b1 = high.y / length(vec2(z, high.y));
    float g2 = atan(-z * length(vec3(low.x, high.y, z)), low.x * high.y);
    float g3 = atan(-z * length(vec3(low, z)), -low.x * low.y);
    float turn = u.x * solid_angle(r, x) - g2 - g3;
    float f = (cos(turn) * b0 - b1) / sin(turn);
    float cu = sign(f) / sqrt(f * f + b0 * b0);
    float s = clamp(-cu * z / sqrt(max(1.0 - cu * cu, 1e-12)), low.x, high.x);
    return normalize(s * ex + mix(low.y, high.y, u.y) * ey + z * ez);
}
// mistake sign_of_f_forgotten
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    vec3 ex = normalize(r.edge_u), ey = normalize(r.edge_v), ez = cross(ex, ey);
    vec3 corner = r.corner - x;
    if (dot(corner, ez) > 0.0) ez = -ez;
    float z = dot(corner, ez);
    vec2 low = vec2(dot(corner, ex), dot(corner, ey));
    vec2 high = low + vec2(length(r.edge_u), length(r.edge_v));
    float b0 = -low.y / length(vec2(z, low.y)), b1 = high.y / length(vec2(z, high.y));
    float g2 = atan(-z * length(vec3(low.x, high.y, z)), low.x * high.y);
    float g3 = atan(-z * length(vec3(low, z)), -low.x * low.y);
    float turn = u.x * solid_angle(r, x) - g2 - g3;
    float f = (cos(turn) * b0 - b1) / sin(turn);
    float cu = 1.0 / sqrt(f * f + b0 * b0);
    float s = clamp(-cu * z / sqrt(max(1.0 - cu * cu, 1e-12)), low.x, high.x);
    float d2 = s * s + z * z;
    float h = mix(low.y / sqrt(d2 + low.y * low.y), high.y / sqrt(d2 + high.y * high.y), u.y);
    return normalize(s * ex + h * sqrt(d2 / (1.0 - h * h)) * ey + z * ez);
}
// mistake from_the_lamp
vec3 direction_to(Rectangle r, vec3 x, vec2 u) { return normalize(x - point_on(r, u)); }
// mistake from_the_origin
vec3 direction_to(Rectangle r, vec3 x, vec2 u) { return normalize(point_on(r, u)); }
// mistake half_the_solid_angle
vec3 direction_to(Rectangle r, vec3 x, vec2 u) {
    vec3 ex = normalize(r.edge_u), ey = normalize(r.edge_v), ez = cross(ex, ey);
    vec3 corner = r.corner - x;
    if (dot(corner, ez) > 0.0) ez = -ez;
    float z = dot(corner, ez);
    vec2 low = vec2(dot(corner, ex), dot(corner, ey));
    vec2 high = low + vec2(length(r.edge_u), length(r.edge_v));
    float b0 = -low.y / length(vec2(z, low.y)), b1 = high.y / length(vec2(z, high.y));
    float g2 = atan(-z * length(vec3(low.x, high.y, z)), low.x * high.y);
    float g3 = atan(-z * length(vec3(low, z)), -low.x * low.y);
    float turn = 0.5 * u.x * solid_angle(r, x) - g2 - g3;
    float f = (cos(turn) * b0 - b1) / sin(turn);
    float cu = sign(f) / sqrt(f * f + b0 * b0);
    float s = clamp(-cu * z / sqrt(max(1.0 - cu * cu, 1e-12)), low.x, high.x);
    float d2 = s * s + z * z;
    float h = mix(low.y / sqrt(d2 + low.y * low.y), high.y / sqrt(d2 + high.y * high.y), u.y);
    return normalize(s * ex + h * sqrt(d2 / (1.0 - h * h)) * ey + z * ez);
}
