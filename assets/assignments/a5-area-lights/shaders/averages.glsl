// What the checks average. Nothing is to be written here.
#include "estimator.glsl"

// The mean of `count` samples of L_r at the origin of a horizontal surface, under the lamp of radiance 1 cd/m².
float average(int count, float seed) {
    float sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += L_r_of_sample(lamp(0.3, 0.5), 1.0, vec3(0.0), vec3(0.0, 0.0, 1.0), 1.0, random_2d(seed, i));
    return sum / float(count);
}
