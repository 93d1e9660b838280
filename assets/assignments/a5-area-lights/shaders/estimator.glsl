// A5.6: the estimator.
#include "rectangle.glsl"
#include "assignment/not_implemented.glsl"

// begin solution A5.6
// f_r L_e cosθ_i / p(wi) of one point of the lamp, with f_r = rho/π                     [cd/m²]
//
// L_e is the lamp's radiance [cd/m²], n the normal at x. The point is point_on(r, u); its density is p_direction.
// Where the lamp lies below the surface, and where x lies behind the lamp, the result is 0.
float L_r_of_sample(Rectangle r, float L_e, vec3 x, vec3 n, float rho, vec2 u) {
    vec3 y = point_on(r, u);
    float p = p_direction(r, x, y);
    float cos_i = max(0.0, dot(n, normalize(y - x)));
    return p > 0.0 ? rho / pi * L_e * cos_i / p : 0.0;
}
// end
