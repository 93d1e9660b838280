// What the checks average. Nothing is to be written here.
#include "estimators.glsl"
#include "strata.glsl"

// The mean of `count` samples by lamp and lobe. n, wo and the lamp lie in one line.
float average(int count, float seed) {
    const vec3 n = vec3(0.0, 0.0, 1.0);
    float sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += L_r_by_both(n, n, n, lobe_exponent, random_2d(seed, 2 * i), random_2d(seed, 2 * i + 1));
    return sum / float(count);
}
