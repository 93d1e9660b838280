// solution by_lambda
float Lambda(float c, float alpha) { return 0.5 * (sqrt(1.0 + alpha * alpha * (1.0 - c * c) / (c * c)) - 1.0); }
float V(float cos_i, float cos_o, float alpha) {
    return 1.0 / (1.0 + Lambda(cos_i, alpha) + Lambda(cos_o, alpha)) / (4.0 * cos_i * cos_o);
}
// solution by_mix
float V(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    return 1.0 / (2.0 * (cos_i * sqrt(mix(cos_o * cos_o, 1.0, a2)) + cos_o * sqrt(mix(cos_i * cos_i, 1.0, a2))));
}
// mistake four_cosines_missing
float V(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    float o = cos_i * sqrt(cos_o * cos_o * (1.0 - a2) + a2);
    float i = cos_o * sqrt(cos_i * cos_i * (1.0 - a2) + a2);
    return 2.0 * cos_i * cos_o / (o + i);
}
// mistake half_missing
float V(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    float o = cos_i * sqrt(cos_o * cos_o * (1.0 - a2) + a2);
    float i = cos_o * sqrt(cos_i * cos_i * (1.0 - a2) + a2);
    return 1.0 / (o + i);
}
// mistake alpha_not_squared
float V(float cos_i, float cos_o, float alpha) {
    float o = cos_i * sqrt(cos_o * cos_o * (1.0 - alpha) + alpha);
    float i = cos_o * sqrt(cos_i * cos_i * (1.0 - alpha) + alpha);
    return 0.5 / (o + i);
}
// mistake factors_swapped
float V(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    float o = cos_o * sqrt(cos_o * cos_o * (1.0 - a2) + a2);
    float i = cos_i * sqrt(cos_i * cos_i * (1.0 - a2) + a2);
    return 0.5 / (o + i);
}
// mistake one_side_twice
float V(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    float o = cos_i * sqrt(cos_o * cos_o * (1.0 - a2) + a2);
    return 0.5 / (o + o);
}
// mistake product_not_sum
float V(float cos_i, float cos_o, float alpha) {
    float a2 = alpha * alpha;
    float o = cos_o + sqrt(cos_o * cos_o * (1.0 - a2) + a2);
    float i = cos_i + sqrt(cos_i * cos_i * (1.0 - a2) + a2);
    return 1.0 / (o * i);
}
