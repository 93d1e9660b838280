// The angle of v from the x axis, in (-π, π], to 1e-6: drivers promise 4096 ulp for atan(), and Mesa errs by 1e-5.
// Turned towards x until it is below π/16 (adding its length to v.x halves the angle), then Gregory's series.
#include "base/constants.glsl"

float angle_of(vec2 v) {
    vec2 h = abs(v);
    if (h.x + h.y == 0.0) return 0.0;
    for (int halving = 0; halving < 3; ++halving) h.x += length(h);
    float t = h.y / h.x;
    float t2 = t * t;
    float angle = 8.0 * t * (1.0 - t2 * (1.0 / 3.0 - t2 * (1.0 / 5.0 - t2 * (1.0 / 7.0 - t2 / 9.0))));
    if (v.x < 0.0) angle = pi - angle;
    return v.y < 0.0 ? -angle : angle;
}
