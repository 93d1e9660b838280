// The outline of an emitter as x sees it, through a linear map: a closed convex loop of straight and round pieces,
// counter-clockwise as seen from x. Absent (count = 0) where x is behind or inside the emitter.
#include "interface/lights.glsl"
#include "light/horizon.glsl"

struct Outline {
    int count;        // pieces
    bool is_flat;     // all of them straight
    int first_texel;  // of a polygon's corners in light_table; negative: corners[] has them
    bool is_reversed; // a polygon's corners, to go round counter-clockwise
    mat3 warp;        // of directions
    vec3 x;           // [m]
    vec3 corners[4];  // from x [m]
    vec3 edges[4];    // to the next corner
    Arc cone;         // of a disk or sphere, and of a tube's first end
    Arc other_cone;   // of its second
};

Outline empty_outline(vec3 x, mat3 warp) {
    return Outline(0, true, -1, false, warp, x, vec3[4](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)),
                   vec3[4](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)), no_arc, no_arc);
}

// An end of a tube comes in two parts, cut where it is lowest, so that neither is visible at both ends only.
Arc part_of_end(Arc cone, bool is_second) {
    float lowest = lowest_of(cone);
    if (lowest < cone.from) lowest += 2.0 * pi;
    lowest = min(lowest, cone.to);
    return Arc(cone.axes, cone.size, is_second ? lowest : cone.from, is_second ? cone.to : lowest);
}

// Piece k of 0 .. count - 1.
Piece piece_at(Outline outline, int k) {
    bool is_single = outline.count == 1;
    if (!outline.is_flat && (is_single || k % 3 != 0)) { // a tube has straight pieces for its first and its fourth
        Arc cone = outline.cone;
        if (k >= 3) cone = outline.other_cone;
        if (!is_single) cone = part_of_end(cone, k % 3 == 2);
        return round_piece(cone);
    }
    vec3 corner, edge;
    if (outline.first_texel >= 0) {
        int n = outline.count;
        int from = outline.is_reversed ? (n - k) % n : k;
        int to = outline.is_reversed ? n - 1 - k : (k + 1) % n;
        vec3 a = texelFetch(light_table, outline.first_texel + from).xyz;
        corner = a - outline.x;
        edge = texelFetch(light_table, outline.first_texel + to).xyz - a;
    } else {
        int i = outline.is_flat ? k : k / 3;
        corner = outline.corners[i];
        edge = outline.edges[i];
    }
    return straight_piece(outline.warp * corner, outline.warp * edge);
}

// Whether x is on a flat emitter's bright side. `front` is the normal there, to_corner leads from x to any point of it.
bool faces(vec3 front, vec3 to_corner, bool is_two_sided) {
    float towards = dot(front, to_corner);
    return is_two_sided ? towards != 0.0 : towards < 0.0;
}

Outline rectangle_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 c = light.position - x;
    if (!faces(light.direction, c, light.is_two_sided)) return o;
    o.count = 4;
    vec3 u = light.half_u;
    vec3 v = dot(light.direction, c) < 0.0 ? -light.half_v : light.half_v; // the front is seen the other way round
    o.corners = vec3[4](c - u - v, c + u - v, c + u + v, c - u + v);
    o.edges = vec3[4](2.0 * u, 2.0 * v, -2.0 * u, -2.0 * v);
    return o;
}

Outline triangle_outline(vec3 a, vec3 b, vec3 c, bool is_two_sided, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 front = cross(b - a, c - a);
    if (!faces(front, a - x, is_two_sided)) return o;
    o.count = 3;
    if (dot(front, a - x) < 0.0) {
        vec3 swapped = b;
        b = c;
        c = swapped;
    }
    o.corners = vec3[4](a - x, b - x, c - x, vec3(0.0));
    o.edges = vec3[4](b - a, c - b, a - c, vec3(0.0));
    return o;
}

Outline polygon_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 c = light.position - x;
    if (!faces(light.direction, c, light.is_two_sided)) return o;
    o.count = light.count;
    o.first_texel = light.data;
    o.is_reversed = dot(light.direction, c) < 0.0;
    return o;
}
