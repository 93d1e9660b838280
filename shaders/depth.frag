#version 410 core
// The depth pre-pass: which surface a pixel sees.
#include "surface/cut_out.glsl"

void main() { cut_out(); }
