// solution one_loop
int first_met(vec3 x, vec3 w) {
    vec2 best = vec2(3.0e38, -1.0);
    for (int i = triangle_count() - 1; i >= 0; --i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t != no_hit && t <= best.x) best = vec2(t, float(i));
    }
    return int(best.y);
}
vec3 L_i(vec3 x, vec3 w) {
    vec3 L = vec3(0.0);
    float nearest = 3.0e38;
    for (int i = 0; i < triangle_count(); ++i) {
        Triangle y = triangle_at(i);
        float t = distance_to(x, w, y);
        if (t == no_hit || t >= nearest) continue;
        nearest = t;
        L = dot(cross(y.c - y.b, y.a - y.b), -w) > 0.0 ? y.L_e : vec3(0.0);
    }
    return L;
}
// solution by_a_step
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 0.0;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t < 0.0) continue;
        if (first == -1 || t < nearest) {
            first = i;
            nearest = t;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i == -1) return vec3(0.0);
    Triangle y = triangle_at(i);
    vec3 n_y = normalize(cross(y.a - y.c, y.b - y.c));
    return step(0.0, dot(n_y, -w)) * y.L_e;
}
// mistake last_in_the_list
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    return is_front ? y.L_e : vec3(0.0);
}
// mistake first_in_the_list
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t < nearest) {
            nearest = t;
            return i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    return is_front ? y.L_e : vec3(0.0);
}
// mistake furthest
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 0.0;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t > nearest) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    return is_front ? y.L_e : vec3(0.0);
}
// mistake misses_count
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t < nearest) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    return is_front ? y.L_e : vec3(0.0);
}
// mistake back_shines
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t < nearest) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    return y.L_e;
}
// mistake front_is_dark
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t < nearest) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) > 0.0;
    return is_front ? y.L_e : vec3(0.0);
}
// mistake only_emitters
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t < nearest && triangle_at(i).L_e != vec3(0.0)) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    return is_front ? y.L_e : vec3(0.0);
}
// mistake inverse_square
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t < nearest) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    float d = distance_to(x, w, y);
    return is_front ? y.L_e / (d * d) : vec3(0.0);
}
// mistake cosine_of_the_lamp
int first_met(vec3 x, vec3 w) {
    int first = -1;
    float nearest = 1e30;
    for (int i = 0; i < triangle_count(); ++i) {
        float t = distance_to(x, w, triangle_at(i));
        if (t > 0.0 && t < nearest) {
            nearest = t;
            first = i;
        }
    }
    return first;
}
vec3 L_i(vec3 x, vec3 w) {
    int i = first_met(x, w);
    if (i < 0) return vec3(0.0);
    Triangle y = triangle_at(i);
    bool is_front = dot(cross(y.b - y.a, y.c - y.a), w) < 0.0;
    float cos_y = dot(normalize(cross(y.b - y.a, y.c - y.a)), -w);
    return is_front ? y.L_e * cos_y : vec3(0.0);
}
