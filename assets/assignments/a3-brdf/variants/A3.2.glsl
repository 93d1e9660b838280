// solution by_the_tangent
float D(float cos_h, float alpha) {
    float c2 = cos_h * cos_h;
    float tan2 = (1.0 - c2) / c2;
    float q = 1.0 + tan2 / (alpha * alpha);
    return 1.0 / (pi * alpha * alpha * c2 * c2 * q * q);
}
// solution by_the_sine
float D(float cos_h, float alpha) {
    float k = alpha / (alpha * alpha * cos_h * cos_h + (1.0 - cos_h) * (1.0 + cos_h));
    return k * k / pi;
}
// mistake pi_missing
float D(float cos_h, float alpha) {
    float d = cos_h * cos_h * (alpha * alpha - 1.0) + 1.0;
    return alpha * alpha / (d * d);
}
// mistake alpha_not_squared
float D(float cos_h, float alpha) {
    float d = cos_h * cos_h * (alpha - 1.0) + 1.0;
    return alpha / (pi * d * d);
}
// mistake alpha_squared_twice
float D(float cos_h, float alpha) {
    float a2 = alpha * alpha * alpha * alpha;
    float d = cos_h * cos_h * (a2 - 1.0) + 1.0;
    return a2 / (pi * d * d);
}
// mistake denominator_not_squared
float D(float cos_h, float alpha) {
    float a2 = alpha * alpha;
    return a2 / (pi * (cos_h * cos_h * (a2 - 1.0) + 1.0));
}
// mistake cosine_not_squared
float D(float cos_h, float alpha) {
    float a2 = alpha * alpha;
    float d = cos_h * (a2 - 1.0) + 1.0;
    return a2 / (pi * d * d);
}
// mistake pi_squared
float D(float cos_h, float alpha) {
    float a2 = alpha * alpha;
    float d = pi * (cos_h * cos_h * (a2 - 1.0) + 1.0);
    return a2 / (d * d);
}
// mistake times_cosine
float D(float cos_h, float alpha) {
    float a2 = alpha * alpha;
    float d = cos_h * cos_h * (a2 - 1.0) + 1.0;
    return cos_h * a2 / (pi * d * d);
}
