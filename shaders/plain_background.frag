#version 410 core
// The radiance where there is no surface and no environment. It has no coverage.
uniform vec3 background; // [cd/m²]

out vec4 frame;

void main() { frame = vec4(background, 0.0); }
