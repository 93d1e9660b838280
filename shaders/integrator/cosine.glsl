// cosθ_i: where wi is below n there is none, and where it is below the surface that a normal map bends n away from, none either:
// light does not come through a surface from behind. Not positive where wi is below n; not a number where there is no wi.
// Through a sheet that transmits diffusely it does come: there it is |cosθ_i|, where wi is below both normals, too.
#include "interface/features.glsl"
#include "surface/surface.glsl"

float cosine(Surface x, vec3 wi) {
    if (has_diffuse_transmission && dot(x.n, wi) < 0.0)
        return has_normal_texture && dot(x.unmapped_n, wi) >= 0.0 ? 0.0 : -dot(x.n, wi);
    if (has_normal_texture && dot(x.unmapped_n, wi) <= 0.0) return 0.0;
    return dot(x.n, wi);
}
