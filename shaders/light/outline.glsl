// The outline of an emitter as x sees it, through a linear map: a closed convex loop of straight and round pieces,
// counter-clockwise as seen from x. Absent (count = 0) where x is behind or inside the emitter.
#include "interface/lights.glsl"
#include "light/horizon.glsl"

struct Outline {
    int count;        // pieces
    int straight;     // how many of them are straight; a tube's come first, third and last but one
    int first_texel;  // of a polygon's corners in light_table; negative: corners[] and edges[] have them
    bool is_reversed; // a polygon's corners, to go round counter-clockwise
    mat3 warp;        // of directions
    vec3 x;           // [m]
    vec3 corners[4];  // from x, warped [m]
    vec3 edges[4];    // to the next corner
    Arc arcs[4];
};

Outline empty_outline(vec3 x, mat3 warp) {
    return Outline(0, 0, -1, false, warp, x, vec3[4](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)),
                   vec3[4](vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0)), Arc[4](no_arc, no_arc, no_arc, no_arc));
}

vec3 polygon_corner(Light light, int k) { return texelFetch(light_table, light.data + k).xyz; }

// Piece k of 0 .. count - 1.
Piece piece_at(Outline outline, int k) {
    if (outline.straight == 0) return round_piece(outline.arcs[k]);
    if (outline.first_texel >= 0) {
        int n = outline.count;
        int from = outline.is_reversed ? (n - k) % n : k;
        int to = outline.is_reversed ? n - 1 - k : (k + 1) % n;
        vec3 a = texelFetch(light_table, outline.first_texel + from).xyz;
        vec3 b = texelFetch(light_table, outline.first_texel + to).xyz;
        return straight_piece(outline.warp * (a - outline.x), outline.warp * (b - a));
    }
    if (outline.straight == outline.count) return straight_piece(outline.corners[k], outline.edges[k]);
    // A tube: a straight piece, two of its one end, a straight piece, two of the other.
    int half_way = k / 3;
    if (k % 3 == 0) return straight_piece(outline.corners[half_way], outline.edges[half_way]);
    return round_piece(outline.arcs[2 * half_way + k % 3 - 1]);
}

// The flat emitters: `front` is the unit normal of the emitting side, to_corner leads from x to any of its points.
bool faces(vec3 front, vec3 to_corner, bool is_two_sided) {
    float towards = dot(front, to_corner);
    return is_two_sided ? towards != 0.0 : towards < 0.0;
}

Outline rectangle_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 to_center = light.position - x;
    if (!faces(light.direction, to_center, light.is_two_sided)) return o;
    o.count = o.straight = 4;
    float side = dot(light.direction, to_center) < 0.0 ? -1.0 : 1.0; // seen from the front it goes the other way
    vec3 u = warp * light.half_u;
    vec3 v = warp * (side * light.half_v);
    vec3 c = warp * to_center;
    o.corners = vec3[4](c - u - v, c + u - v, c + u + v, c - u + v);
    o.edges = vec3[4](2.0 * u, 2.0 * v, -2.0 * u, -2.0 * v);
    return o;
}

Outline triangle_outline(vec3 a, vec3 b, vec3 c, bool is_two_sided, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 front = cross(b - a, c - a);
    if (!faces(front, a - x, is_two_sided)) return o;
    o.count = o.straight = 3;
    if (dot(front, a - x) < 0.0) {
        vec3 swapped = b;
        b = c;
        c = swapped;
    }
    o.corners = vec3[4](warp * (a - x), warp * (b - x), warp * (c - x), vec3(0.0));
    o.edges = vec3[4](warp * (b - a), warp * (c - b), warp * (a - c), vec3(0.0));
    return o;
}

Outline polygon_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 to_center = light.position - x;
    if (!faces(light.direction, to_center, light.is_two_sided)) return o;
    o.count = o.straight = light.count;
    o.first_texel = light.data;
    o.is_reversed = dot(light.direction, to_center) < 0.0;
    return o;
}
