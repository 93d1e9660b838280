// solution running_mean
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 mean = vec3(0.0);
    for (int i = 0; i < count; ++i) mean += (V_between(x, n, point_on_lamp(random_2d(seed, i))) - mean) / float(i + 1);
    return mean;
}
// solution backwards
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    float weight = 1.0 / float(count);
    vec3 mean = vec3(0.0);
    while (--count >= 0) {
        vec2 u = random_2d(seed, count);
        mean += weight * V_between(x, n, lamp_corner + u.y * lamp_v + u.x * lamp_u);
    }
    return mean;
}
// mistake sum_for_mean
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) sum += V_between(x, n, point_on_lamp(random_2d(seed, i)));
    return sum;
}
// mistake one_point
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) sum += V_between(x, n, point_on_lamp(random_2d(seed, 0)));
    return sum / float(count);
}
// mistake center_alone
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) sum += V_between(x, n, point_on_lamp(vec2(0.5)));
    return sum / float(count);
}
// mistake on_the_diagonal
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) sum += V_between(x, n, point_on_lamp(random_2d(seed, i).xx));
    return sum / float(count);
}
// mistake one_point_less
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 sum = vec3(0.0);
    for (int i = 1; i < count; ++i) sum += V_between(x, n, point_on_lamp(random_2d(seed, i)));
    return sum / float(count);
}
// mistake mean_point
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 mean = vec3(0.0);
    for (int i = 0; i < count; ++i) mean += point_on_lamp(random_2d(seed, i)) / float(count);
    return V_between(x, n, mean);
}
// mistake shadow_for_V
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) sum += V_between(x, n, point_on_lamp(random_2d(seed, i)));
    return 1.0 - sum / float(count);
}
// mistake all_must_see
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 least = vec3(1.0);
    for (int i = 0; i < count; ++i) least = min(least, V_between(x, n, point_on_lamp(random_2d(seed, i))));
    return least;
}
