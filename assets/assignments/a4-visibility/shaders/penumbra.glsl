// A4.5: the shadow of a lamp that has a size.
#include "rays.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A4.5
// The mean of V(x, y) over `count` points y of the lamp, by colour                      [1]
//
// Point i, from 0 to count - 1, is point_on_lamp(random_2d(seed, i)). Call V_between.
vec3 V_of_lamp(vec3 x, vec3 n, int count, float seed) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) sum += V_between(x, n, point_on_lamp(random_2d(seed, i)));
    return sum / float(count);
}
// end
