// The arrays of the mesh, for shaders that look up a triangle: its positions first, and the others where the block Object
// says.
#include "interface/object.glsl"

uniform samplerBuffer mesh_floats;
uniform usamplerBuffer mesh_indices; // three a triangle

int vertex_of(int triangle, int corner) { return int(texelFetch(mesh_indices, 3 * triangle + corner).r); }

float mesh_float(int i) { return texelFetch(mesh_floats, i).r; }

vec2 mesh_vec2(int first, int vertex) {
    int i = first + 2 * vertex;
    return vec2(mesh_float(i), mesh_float(i + 1));
}

vec3 mesh_vec3(int first, int vertex) {
    int i = first + 3 * vertex;
    return vec3(mesh_float(i), mesh_float(i + 1), mesh_float(i + 2));
}

vec4 mesh_vec4(int first, int vertex) {
    int i = first + 4 * vertex;
    return vec4(mesh_float(i), mesh_float(i + 1), mesh_float(i + 2), mesh_float(i + 3));
}

// World space [m].
vec3 corner_position(int vertex) { return (world_from_object * vec4(mesh_vec3(0, vertex), 1.0)).xyz; }
