// surface_at_fragment(): from interpolated vertices and textures to the point x of the equation.
#include "interface/frame.glsl"
#include "interface/object.glsl"
#include "surface/glass.glsl"
#include "surface/material.glsl"
#include "surface/shading_normal.glsl"
#include "surface/surface.glsl"

// wo: the unit direction from x to the viewer.
vec3 direction_to_viewer() {
    return eye.w == 0.0 ? eye.xyz : unit_or(eye.xyz - vertex_position, vec3(0.0, 0.0, 1.0));
}

// After the layers, whose coat lies over the glass.
void add_glass(inout Surface x, vec3 wo) {
    bool leaves_body = handedness.z != 0.0 && !is_front();
    vec3 optical_depth = leaves_body ? vec3(0.0) : attenuation_factor.rgb * (handedness.y * thickness());
    float F0 = max(x.F0_dielectric.r, max(x.F0_dielectric.g, x.F0_dielectric.b));
    vec3 color = (1.0 - x.metallic) * x.transmission * x.base_color;
    Glass glass = Glass(color, F0, x.specular, has_clearcoat ? x.clearcoat : 0.0, optical_depth);
    vec3 T = straight_transmittance(glass, max(dot(x.n, wo), 0.0));
    x.alpha_coverage = x.coverage;
    x.through = mix(vec3(1.0), T, x.alpha_coverage);
    x.coverage = 1.0 - dot(x.through, vec3(1.0 / 3.0));
}

Surface surface_at_fragment() {
    find_fragment();
    vec4 color = base_color();
    // The depth pre-pass cuts opaque surfaces out; glass has none.
    if (is_transmissive && is_masked && color.a < alpha_cutoff) discard;
    if (is_other_part()) discard;
    vec3 wo = direction_to_viewer();

    Surface x;
    x.position = vertex_position;
    x.triangle = is_line || is_point ? -1 : first_triangle + triangle_of_mesh();
    x.n = shading_normal(wo);
    x.unmapped_n = on_seen_side(interpolated_normal(), wo);
    x.coverage = is_blended ? color.a : 1.0;
    add_material(x, color, wo);
    if (is_transmissive) add_glass(x, wo);
    return x;
}
