// surface_at_fragment(): from interpolated vertices and textures to the point x of the equation.
#include "interface/frame.glsl"
#include "interface/object.glsl"
#include "surface/shading_normal.glsl"
#include "surface/surface.glsl"

// alpha = roughness²: Burley 2012, section 5.4, and glTF 2.0 Appendix B. A perfect mirror (alpha = 0) has no density
// that a point light could be seen in; below 1e-4 the square of alpha² leaves the range of floats in comfort.
const float smallest_alpha = 1e-4;

// wo: the unit direction from x to the viewer.
vec3 direction_to_viewer() {
    return eye.w == 0.0 ? eye.xyz : normalize(eye.xyz - vertex_position);
}

Surface surface_at_fragment() {
    vec4 color = base_color();
    vec2 rm = clamp(roughness_metallic(), 0.0, 1.0);
    vec4 layer = specular();

    Surface x;
    x.position = vertex_position;
    x.triangle = first_triangle + gl_PrimitiveID;
    x.n = shading_normal(direction_to_viewer());
    x.base_color = color.rgb;
    x.metallic = rm.y;
    x.alpha = max(rm.x * rm.x, smallest_alpha);
    x.F0_dielectric = min(F0_from_ior * layer.rgb, vec3(1.0));
    x.specular = layer.a;
    x.emission = emission();
    x.coverage = is_blended ? color.a : 1.0;
    return x;
}
