// solution by_trapezoids
vec3 XYZ_of_lamp(float power, float peak, float width) {
    vec3 sum = vec3(0.0);
    for (int nm = 380; nm <= 780; ++nm) {
        float weight = nm == 380 || nm == 780 ? 0.5 : 1.0;
        sum += weight * S(float(nm), power, peak, width) * observer(float(nm));
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return dot(XYZ, vec3(0.0, 683.0, 0.0)); }
// solution channel_by_channel
float integral(int channel, float power, float peak, float width) {
    float sum = 0.0;
    for (float lambda = 381.0; lambda < 780.0; lambda += 2.0)
        sum += observer(lambda)[channel] * S(lambda, 1.0, peak, width);
    return 2.0 * power * sum;
}
vec3 XYZ_of_lamp(float power, float peak, float width) {
    return vec3(integral(0, power, peak, width), integral(1, power, peak, width), integral(2, power, peak, width));
}
float luminous_flux(vec3 XYZ) { return XYZ.g * 683.0; }
// mistake step_missing
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda);
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake step_in_metres
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda) * d_lambda * metres_per_nm;
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake mean_for_integral
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda);
    }
    return sum / float(steps);
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake observer_missing
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * vec3(1.0) * d_lambda;
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake spectrum_missing
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += power * observer(lambda) * d_lambda;
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake range_too_short
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 60;
    float d_lambda = (700.0 - 400.0) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = 400.0 + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda) * d_lambda;
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake peak_alone
vec3 XYZ_of_lamp(float power, float peak, float width) { return power * observer(peak); }
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake channels_swapped
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda) * d_lambda;
    }
    return sum.zyx;
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.y; }
// mistake efficacy_missing
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda) * d_lambda;
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return XYZ.y; }
// mistake flux_of_X
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda) * d_lambda;
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return 683.0 * XYZ.x; }
// mistake flux_of_all_three
vec3 XYZ_of_lamp(float power, float peak, float width) {
    const int steps = 80;
    float d_lambda = (longest - shortest) / float(steps);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < steps; ++i) {
        float lambda = shortest + (float(i) + 0.5) * d_lambda;
        sum += S(lambda, power, peak, width) * observer(lambda) * d_lambda;
    }
    return sum;
}
float luminous_flux(vec3 XYZ) { return 683.0 * (XYZ.x + XYZ.y + XYZ.z); }
