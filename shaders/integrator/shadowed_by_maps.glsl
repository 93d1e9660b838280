// The shadow of an emitter of finite size by depth maps from N points on it (--visibility map).
//
//   L = U m/n + (n Σ w_i V_i - m Σ w_i) / (N (n - 1)),      m = Σ V_i, over the n points whose w_i is not 0
//
// U is what the emitter would reflect without shadows, by the samples of every pixel and with all their skill; w_i what a
// point does, f_r L_i cosθ / p. E[w V] = E[w] E[V] + cov(w, V), and U knows E[w] better than the points. Each point's
// share is (w_i V_i + (U - w_i) V') / N, where V' is the mean V of the other points, or where none of these shines, as
// on surfaces whose horizon cuts the emitter, V of its middle: whatever V' is, as long as w_i and U are independent of
// it the mean over frames is exactly ∫ f_r L_e V cosθ dω. Where V is 1 this is U, where V is 0 it is 0; only penumbrae
// see the points.
#include "surface/surface.glsl"
#include "brdf/f_r.glsl"
#include "integrator/cosine.glsl"
#include "light/map_sample.glsl"
#include "visibility/map.glsl"

vec3 shadowed(vec3 U, int k, Surface x, vec3 wo) {
    if (!has_extent(k)) return U;
    int N = point_count(k);
    vec3 w_V = vec3(0.0);
    vec3 w_sum = vec3(0.0);
    float n = 0.0;
    vec3 m = vec3(0.0);
    vec3 V = vec3(0.0); // in the end that of the middle, where it is needed
    for (int i = 0; i < N || (i == N && n < 2.0); ++i) {
        MapPoint y = map_point(k, i);
        LightSample light = sample_from_point(k, y, x.position);
        float cos_i = cosine(x, light.wi);
        bool shines = light.Li_over_p != vec3(0.0);
        V = vec3(0.0);
        if (shines) V = V_by_map(x, y, light.wi, light.distance, k);
        if (i == N || !shines || !(cos_i > 0.0)) continue;
        vec3 w = f_r(x, light.wi, wo) * light.Li_over_p * cos_i;
        w_V += V * w;
        w_sum += w;
        n += 1.0;
        m += V;
    }
    if (n > 1.0) return U * (m / n) + (n * w_V - m * w_sum) / (float(N) * (n - 1.0));
    if (n == 0.0) return V * U;
    return (w_V + V * (U - w_sum) + float(N - 1) * m * U) / float(N);
}
