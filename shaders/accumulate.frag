#version 410 core
// Adds the frame to the Film (the blend function does the adding).
uniform sampler2D frame;

out vec4 film;

void main() { film = texelFetch(frame, ivec2(gl_FragCoord.xy), 0); }
