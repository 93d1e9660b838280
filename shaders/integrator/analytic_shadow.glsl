// Shadow samples of an emitter that analytic_lobe.glsl integrates: one of its points, chosen
// in proportion to its contribution, and moved within the part of the emitter that it represents. Two random numbers, one
// along the outline and one across, name the point and its place, so that evenly spread numbers look evenly over what
// is lit.
#include "integrator/analytic_lobe.glsl"

struct Chosen {
    vec3 wi;
    int part;
    float left;   // of what the points add, in their order, this much is to be passed
    float across; // a random number
    bool is_found;
};

void choose_in_outline(WarpedLobe lobe, Light light, int part, int parts, Surface x, vec3 wo, inout Chosen chosen) {
    Outline outline = outline_of(light, part, x.position, lobe.warp.warped_from_world);
    VisibleOutline v = visible_part(outline);
    if (!(v.E > 0.0)) return;
    vec3 mean = analytic_points == 0 ? mean_ratio(v.center, lobe, light, part, x, wo) : vec3(0.0);
    for (int k = 0; k <= outline.count; ++k) {
        Arc arc = arc_of(outline, v, k);
        int steps = steps_of(arc, v, points_of_a_lobe(parts) / points_a_step);
        for (int i = 0; i < steps; ++i) {
            QuadratureStep slice = quadrature_step(arc, float(i) + 0.5, steps, v.center);
            vec2 amounts; // of the step's two points
            for (int j = 0; j < points_a_step; ++j) {
                vec3 q = quadrature_point(slice, quadrature_distance(j), v.center);
                amounts[j] = slice.weight * q.z
                             * brightness(analytic_points == 0 ? mean : ratio_at(q, lobe, light, part, x, wo));
            }
            float amount = amounts.x + amounts.y;
            if (!chosen.is_found && amount > 0.0) {
                float along = min(chosen.left / amount, 1.0);
                float inner = amounts.x / amount;
                bool is_inner = chosen.across < inner;
                float across = is_inner ? chosen.across / inner : (chosen.across - inner) / (1.0 - inner);
                QuadratureStep moved = quadrature_step(arc, float(i) + along, steps, v.center);
                float distance = ((is_inner ? 0.0 : 1.0) + across) / float(points_a_step);
                chosen.wi = lobe.warp.world_from_warped * quadrature_point(moved, distance, v.center);
                chosen.part = part;
                chosen.is_found = chosen.left <= amount;
                chosen.left -= amount;
            }
        }
    }
}
