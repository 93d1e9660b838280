// The outlines of disks, spheres, the sun and tubes.
#include "light/outline.glsl"

Outline disk_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 to_center = light.position - x;
    if (!faces(light.direction, to_center, light.is_two_sided)) return o;
    o.count = 1;
    o.arcs[0] = cone_arc(warp * to_center, warp * light.half_u, warp * light.half_v);
    return o;
}

Outline sphere_outline(vec3 to_center, float radius, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    float d = length(to_center);
    if (d <= radius) return o;
    o.count = 1;
    float sin_sigma = radius / d;
    float cos_sigma = sqrt((d - radius) * (d + radius)) / d;
    o.arcs[0] = round_cone(to_center / d, sin_sigma, cos_sigma, warp);
    return o;
}

Outline sun_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    o.count = 1;
    o.arcs[0] = round_cone(-light.direction, sin(light.radius), cos(light.radius), warp);
    return o;
}

// The round end of a tube around `center` (from x), from the direction of one tangent point to another's. In two
// parts where its lowest point is on the way, so that neither is visible at both ends only.
void tube_end(vec3 center, float radius, vec3 from, vec3 to, mat3 warp, out Arc first, out Arc second) {
    float d = length(center);
    float cos_sigma = sqrt(max((d - radius) * (d + radius), 0.0)) / d;
    first = round_cone(center / d, radius / d, cos_sigma, warp);
    first.from = arc_angle(first, warp * from);
    first.to = arc_angle(first, warp * to);
    if (first.to < first.from) first.to += 2.0 * pi;
    float lowest = lowest_of(first);
    if (lowest < first.from) lowest += 2.0 * pi;
    second = first;
    second.from = second.to = min(lowest, first.to);
    second.to = first.to;
    first.to = second.from;
}

// All points within `radius` of an axis. The silhouette lies in the two planes through x that touch both spheres:
// their unit normals n have n·p = radius for all p of the axis. (x is the origin here.)
Outline tube_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    float radius = light.radius;
    vec3 p1 = light.position - light.half_u - x;
    vec3 axis = 2.0 * light.half_u;
    vec3 p2 = p1 + axis;
    float along = -dot(p1, axis) / dot(axis, axis);
    if (length(p1 + clamp(along, 0.0, 1.0) * axis) <= radius) return o; // inside
    vec3 nearest = p1 + along * axis; // of the axis' line
    float distance = length(nearest);
    // Seen along the axis the nearer end hides all else.
    if (distance <= radius) return sphere_outline(along < 0.5 ? p1 : p2, radius, x, warp);

    vec3 out_of = nearest / distance;
    vec3 across = cross(normalize(axis), out_of);
    float sine = sqrt((distance - radius) * (distance + radius)) / distance;
    vec3 n_low = radius / distance * out_of + sine * across;
    vec3 n_high = radius / distance * out_of - sine * across;
    o.count = 6;
    o.straight = 2;
    o.corners[0] = warp * (p1 - radius * n_low);
    o.corners[1] = warp * (p2 - radius * n_high);
    o.edges[0] = warp * axis;
    o.edges[1] = -o.edges[0];
    tube_end(p2, radius, p2 - radius * n_low, p2 - radius * n_high, warp, o.arcs[0], o.arcs[1]);
    tube_end(p1, radius, p1 - radius * n_high, p1 - radius * n_low, warp, o.arcs[2], o.arcs[3]);
    return o;
}
