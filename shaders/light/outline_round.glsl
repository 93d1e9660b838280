// The outlines of disks, spheres, the sun and tubes.
#include "interface/features.glsl"
#include "light/outline.glsl"

// An ellipse c + a cos t + b sin t through which something round is seen. A cone of half-angle σ around the unit
// direction w is one.
struct Ellipse {
    vec3 c;
    vec3 a;
    vec3 b;
};

Ellipse circle(vec3 w, float sin_sigma, float cos_sigma) {
    vec3 u = perpendicular_to(w);
    return Ellipse(cos_sigma * w, sin_sigma * u, sin_sigma * cross(w, u));
}

Ellipse sphere_circle(vec3 to_center, float radius) {
    float d = length(to_center);
    return circle(to_center / d, radius / d, sqrt(max((d - radius) * (d + radius), 0.0)) / d);
}

// All points within `radius` of an axis. The silhouette lies in the two planes through x that touch both spheres:
// their unit normals n have n·p = radius for all p of the axis. (x is the origin here.) Sets the straight pieces and
// returns whether there are any: seen along the axis the nearer end hides all else.
bool has_sides(Light light, vec3 p1, vec3 p2, inout Outline o) {
    vec3 axis = p2 - p1;
    vec3 nearest = p1 - dot(p1, axis) / dot(axis, axis) * axis; // of the axis' line
    float distance = length(nearest);
    if (distance <= light.radius) return false;
    vec3 out_of = nearest / distance;
    vec3 across = cross(out_of, normalize(axis));
    float sine = sqrt((distance - light.radius) * (distance + light.radius)) / distance;
    vec3 n_low = light.radius / distance * out_of + sine * across;
    vec3 n_high = light.radius / distance * out_of - sine * across;
    o.count = 6;
    o.corner = o.warp * (p1 - light.radius * n_low);
    o.opposite = o.warp * (p2 - light.radius * n_high);
    o.u = o.warp * axis;
    return true;
}

// The part of a tube's round end from one tangent point to another.
void cut_end(inout Arc cone, vec3 from, vec3 to) {
    cone.from = arc_angle(cone, from);
    cone.to = arc_angle(cone, to);
    if (cone.to < cone.from) cone.to += 2.0 * pi;
}

// Disk, sphere, sun or tube: all go through the same few lines, since every copy of cone_arc() takes long to compile.
Outline round_outline(Light light, vec3 x, mat3 warp) {
    Outline o = empty_outline(x, warp);
    vec3 c = light.position - x;
    Ellipse ellipse = circle(-light.direction, sin(light.radius), cos(light.radius)); // the sun's
    Ellipse other = ellipse;
    bool has_two_ends = false;
    bool is_seen = true;
    o.is_flat = false;
    o.count = 1;
    if (has_tube_lights && light.kind == tube_light) {
        vec3 p1 = c - light.half_u;
        vec3 p2 = c + light.half_u;
        float along = -dot(p1, light.half_u) / (2.0 * dot(light.half_u, light.half_u));
        is_seen = length(p1 + clamp(along, 0.0, 1.0) * 2.0 * light.half_u) > light.radius; // not from inside
        has_two_ends = has_sides(light, p1, p2, o);
        other = sphere_circle(p1, light.radius);
        ellipse = sphere_circle(has_two_ends || along >= 0.5 ? p2 : p1, light.radius);
    } else if (has_disk_lights && light.kind == disk_light) {
        is_seen = faces(light, x, c);
        ellipse = Ellipse(c, light.half_u, light.half_v);
    } else if (has_sphere_lights && light.kind == sphere_light) {
        is_seen = length(c) > light.radius;
        ellipse = sphere_circle(c, light.radius);
    }
    if (!is_seen) return empty_outline(x, warp);
    for (int end = 0; end < (has_two_ends ? 2 : 1); ++end) {
        Arc cone = cone_arc(warp * ellipse.c, warp * ellipse.a, warp * ellipse.b);
        if (has_two_ends && end == 0) cut_end(cone, o.corner + o.u, o.opposite);
        if (end == 1) cut_end(cone, o.opposite - o.u, o.corner);
        if (end == 0) o.cone = cone;
        else o.other_cone = cone;
        ellipse = other;
    }
    return o;
}
