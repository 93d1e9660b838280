// solution along_the_whole
vec3 T_of(Triangle triangle) { return mix(vec3(1.0), triangle.tint, triangle.alpha); }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 o = shadow_origin(x, n, normalize(y - x));
    vec3 w = normalize(y - o);
    float end = distance(y, o) * (4095.0 / 4096.0);
    vec3 V = vec3(1.0);
    for (int i = triangle_count() - 1; i >= 0; --i) {
        Triangle triangle = triangle_at(i);
        float t = distance_to(o, w, triangle);
        if (t == no_hit || t > end) continue;
        V = V * T_of(triangle);
        if (V == vec3(0.0)) return V;
    }
    return V;
}
// solution by_logarithms
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha * (1.0 - triangle.tint); }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 o = shadow_origin(x, n, y - x);
    vec3 to_y = y - o;
    vec3 depth = vec3(0.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float share = distance_to(o, normalize(to_y), triangle_at(i)) / length(to_y);
        if (share <= 0.0 || share > 0.9997) continue;
        depth -= log(max(T_of(triangle_at(i)), 1e-30));
    }
    return exp(-depth);
}
// mistake alpha_lets_through
vec3 T_of(Triangle triangle) { return triangle.alpha + (1.0 - triangle.alpha) * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V *= T_of(triangle_at(i));
    }
    return V;
}
// mistake tint_missing
vec3 T_of(Triangle triangle) { return vec3(1.0 - triangle.alpha); }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V *= T_of(triangle_at(i));
    }
    return V;
}
// mistake alpha_missing
vec3 T_of(Triangle triangle) { return triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V *= T_of(triangle_at(i));
    }
    return V;
}
// mistake uncovered_part_missing
vec3 T_of(Triangle triangle) { return triangle.alpha * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V *= T_of(triangle_at(i));
    }
    return V;
}
// mistake last_one_counts
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha + triangle.alpha * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V = T_of(triangle_at(i));
    }
    return V;
}
// mistake losses_added
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha + triangle.alpha * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V -= 1.0 - T_of(triangle_at(i));
    }
    return V;
}
// mistake all_or_nothing
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha + triangle.alpha * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) return vec3(0.0);
    }
    return V;
}
// mistake beyond_y
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha + triangle.alpha * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0) V *= T_of(triangle_at(i));
    }
    return V;
}
// mistake length_1
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha + triangle.alpha * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = shadow_origin(x, n, y - x);
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < (1.0 - exp2(-12.0))) V *= T_of(triangle_at(i));
    }
    return V;
}
// mistake from_x_itself
vec3 T_of(Triangle triangle) { return 1.0 - triangle.alpha + triangle.alpha * triangle.tint; }
vec3 V_between(vec3 x, vec3 n, vec3 y) {
    vec3 origin = x;
    float d = length(y - origin);
    vec3 w = (y - origin) / d;
    vec3 V = vec3(1.0);
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(origin, w, triangle_at(i));
        if (t > 0.0 && t < d * (1.0 - exp2(-12.0))) V *= T_of(triangle_at(i));
    }
    return V;
}
