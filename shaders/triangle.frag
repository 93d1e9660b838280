#version 410 core
// depth.frag for a surface that is shaded pixel by pixel: it writes which triangle of its mesh a pixel sees.
#include "surface/cut_out.glsl"

out int triangle;

void main() {
    cut_out();
    triangle = gl_PrimitiveID;
}
