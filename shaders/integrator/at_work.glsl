// The lights at work (interface/frame.glsl), kind by kind.
#include "interface/features.glsl"
#include "interface/frame.glsl"
#include "interface/lights.glsl"

const int kinds_of_lights = int(has_point_lights) + int(has_spot_lights) + int(has_directional_lights)
                          + int(has_rectangle_lights) + int(has_disk_lights) + int(has_sphere_lights) + int(has_tube_lights)
                          + int(has_polygon_lights) + int(has_mesh_lights) + int(has_environment_lights);

// Kinds have loops of their own if they are few, since each loop takes the compiler time.
const bool has_loop_for_each_kind = kinds_of_lights > 1 && kinds_of_lights <= 4;
const int any_kind = -1;

bool is_at_work(int k) { return k >= first_light && k < end_light; }

// The light after k, of the same kind where kinds have loops of their own; not below end_light: there is none.
int next_at_work(int k) { return has_loop_for_each_kind ? next_in_table(k) : k + 1; }

// The first light at work of this kind; not below end_light: there is none.
int first_at_work(int kind) {
    if (!has_loop_for_each_kind) return first_light;
    int k = first_in_table(kind);
    while (k < first_light) k = next_in_table(k);
    return k;
}

// Light k, which is of this kind: the compiler drops the code of others.
Light light_at_work(int k, int kind) {
    Light light = light_at(k);
    if (kind != any_kind) light.kind = kind;
    return light;
}
