// The outline of an emitter as x sees it, through a linear map: a closed convex loop of straight and round pieces,
// counter-clockwise as seen from x. Absent (count = 0) where x is behind or inside the emitter.
#include "interface/lights.glsl"
#include "light/flat.glsl"
#include "light/horizon.glsl"

struct Outline {
    int count;        // pieces
    bool is_flat;     // all of them straight
    int first_texel;  // of a polygon's corners in light_table; negative: those of a rectangle, or a tube's sides
    bool is_reversed; // a polygon's corners, to go round counter-clockwise
    mat3 warp;        // of directions
    vec3 x;           // [m]
    vec3 corner;      // a rectangle's first; where a tube's first side begins; all from x and warped [m]
    vec3 opposite;    // a rectangle's third; where a tube's second side begins
    vec3 u;           // a rectangle's first edge; a tube's axis
    vec3 v;           // a rectangle's second edge
    Arc cone;         // of a disk or sphere, and of a tube's first end
    Arc other_cone;   // of its second
};

Outline empty_outline(vec3 x, mat3 warp) {
    return Outline(0, true, -1, false, warp, x, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), no_arc, no_arc);
}

// An end of a tube comes in two parts, cut where it is lowest, so that neither is visible at both ends only.
Arc part_of_end(Arc cone, bool is_second) {
    float lowest = lowest_angle(cone);
    if (lowest < cone.from) lowest += 2.0 * pi;
    lowest = min(lowest, cone.to);
    return Arc(cone.axes, cone.size, is_second ? lowest : cone.from, is_second ? cone.to : lowest);
}

// Piece k of 0 .. count - 1. (Selections instead of arrays: these would be looked up lane by lane in software GL.)
Piece piece_at(Outline outline, int k) {
    bool is_single = outline.count == 1;
    bool is_round = has_cones && !outline.is_flat && (is_single || k % 3 != 0); // a tube's sides are first and fourth
    if (is_round) {
        Arc cone = outline.cone;
        if (has_tube_lights && k >= 3) cone = outline.other_cone;
        if (has_tube_lights && !is_single) cone = part_of_end(cone, k % 3 == 2);
        return round_piece(cone);
    }
    if ((has_polygon_lights || has_mesh_lights) && outline.first_texel >= 0) {
        int n = outline.count;
        int from = outline.is_reversed ? (n - k) % n : k;
        int to = outline.is_reversed ? n - 1 - k : (k + 1) % n;
        vec3 a = texelFetch(light_table, outline.first_texel + from).xyz;
        vec3 b = texelFetch(light_table, outline.first_texel + to).xyz;
        return straight_piece(outline.warp * (a - outline.x), outline.warp * (b - outline.x), outline.warp * (b - a));
    }
    bool is_second_half = outline.is_flat ? k >= 2 : k >= 3;
    vec3 corner = is_second_half ? outline.opposite : outline.corner;
    vec3 edge = is_second_half ? -outline.u : outline.u;
    vec3 next = corner + edge;
    if (outline.is_flat && k % 2 == 1)
        return straight_piece(next, is_second_half ? outline.corner : outline.opposite, is_second_half ? -outline.v : outline.v);
    return straight_piece(corner, next, edge);
}

Outline rectangle_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 c = light.position - x;
    if (!faces(light, x, c)) return o;
    o.count = 4;
    vec3 u = light.half_u;
    vec3 v = dot(light.direction, c) < 0.0 ? -light.half_v : light.half_v; // the front is seen the other way round
    o.corner = warp * (c - u - v);
    o.opposite = warp * (c + u + v);
    o.u = warp * (2.0 * u);
    o.v = warp * (2.0 * v);
    return o;
}

// A polygon, or a triangle of a mesh: `count` corners from a texel on, and the normal of its bright side.
Outline polygon_outline(int first_texel, int count, vec3 front, bool is_two_sided, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 to_corner = texelFetch(light_table, first_texel).xyz - x;
    if (!shines_on(front, x, to_corner, is_two_sided)) return o;
    o.count = count;
    o.first_texel = first_texel;
    o.is_reversed = dot(front, to_corner) < 0.0;
    return o;
}

Outline triangle_outline(int first_texel, bool is_two_sided, vec3 x, mat3 warp) {
    vec3 a = texelFetch(light_table, first_texel).xyz;
    vec3 b = texelFetch(light_table, first_texel + 1).xyz;
    vec3 c = texelFetch(light_table, first_texel + 2).xyz;
    return polygon_outline(first_texel, 3, cross(b - a, c - a), is_two_sided, x, warp);
}
