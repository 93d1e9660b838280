#version 410 core
// depth.frag for a surface that is shaded pixel by pixel: it writes which triangle of its mesh a pixel sees.
#include "surface/cut_out.glsl"

uniform bool draws_some; // of the triangles of the mesh
uniform usamplerBuffer triangle_numbers; // of these

out int triangle;

void main() {
    cut_out();
    triangle = draws_some ? int(texelFetch(triangle_numbers, gl_PrimitiveID).r) : gl_PrimitiveID;
}
