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
    o.corners = vec3[4](p1 - light.radius * n_low, p2 - light.radius * n_high, vec3(0.0), vec3(0.0));
    o.edges = vec3[4](axis, -axis, vec3(0.0), vec3(0.0));
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
    o.is_flat = false;
    vec3 c = light.position - x;
    Ellipse ellipses[2];
    bool is_tube = has_tube_lights && light.kind == tube_light;
    bool is_seen = true;
    o.count = 1;
    if (is_tube) {
        vec3 p1 = c - light.half_u;
        vec3 axis = 2.0 * light.half_u;
        float along = clamp(-dot(p1, axis) / dot(axis, axis), 0.0, 1.0);
        is_seen = length(p1 + along * axis) > light.radius; // not from inside
        is_tube = has_sides(light, p1, p1 + axis, o);
        ellipses[0] = sphere_circle(is_tube || along >= 0.5 ? p1 + axis : p1, light.radius);
        ellipses[1] = sphere_circle(p1, light.radius);
    } else if (has_disk_lights && light.kind == disk_light) {
        is_seen = faces(light.direction, c, light.is_two_sided);
        ellipses[0] = Ellipse(c, light.half_u, light.half_v);
    } else if (has_sphere_lights && light.kind == sphere_light) {
        is_seen = length(c) > light.radius;
        ellipses[0] = sphere_circle(c, light.radius);
    } else {
        ellipses[0] = circle(-light.direction, sin(light.radius), cos(light.radius));
    }
    if (!is_seen) return empty_outline(x, warp);
    for (int i = 0; i < (is_tube ? 2 : 1); ++i) {
        Arc cone = cone_arc(warp * ellipses[i].c, warp * ellipses[i].a, warp * ellipses[i].b);
        if (is_tube) {
            vec3 low = warp * o.corners[0];
            vec3 high = warp * o.corners[1];
            vec3 axis = warp * o.edges[0];
            if (i == 0) cut_end(cone, low + axis, high);
            else cut_end(cone, high - axis, low);
        }
        if (i == 0) o.cone = cone;
        else o.other_cone = cone;
    }
    return o;
}
