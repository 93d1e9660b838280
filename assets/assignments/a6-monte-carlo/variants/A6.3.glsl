// solution by_the_ratio
float weight(float p, float q) {
    float odds = q / p;
    return 1.0 / (1.0 + odds * odds);
}
// solution rest_of_1
float weight(float p, float q) { return 1.0 - q * q / dot(vec2(p, q), vec2(p, q)); }
// mistake balance_heuristic
float weight(float p, float q) { return p / (p + q); }
// mistake weight_of_the_other
float weight(float p, float q) { return q * q / (p * p + q * q); }
// mistake one_not_squared
float weight(float p, float q) { return p / (p * p + q * q); }
// mistake square_of_the_sum
float weight(float p, float q) { return p * p / ((p + q) * (p + q)); }
// mistake root_of_the_sum
float weight(float p, float q) { return p / sqrt(p * p + q * q); }
// mistake all_to_the_larger
float weight(float p, float q) { return p > q ? 1.0 : 0.0; }
// mistake half_each
float weight(float p, float q) { return 0.5; }
// mistake divided_by_q
float weight(float p, float q) { return p * p / (q * q); }
