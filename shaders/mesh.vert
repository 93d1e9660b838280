#version 410 core
// Every triangle, line and point of the scene, from object space to the camera's clip space.
#include "base/unit.glsl"
#include "interface/features.glsl"
#include "interface/frame.glsl"
#include "interface/object.glsl"
#include "surface/vertex.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 5) in vec4 color;
layout(location = 6) in vec4 line; // of a line: its other end, and on which side of it this vertex is (±1)

out vec3 vertex_position;
out vec3 vertex_normal;
out vec4 vertex_tangent;
out vec2 vertex_uv0;
out vec2 vertex_uv1;
out vec4 vertex_color;

// The depth pre-pass and the shading pass must agree to the last bit.
invariant gl_Position;

const float line_width = 3.0; // [pixels]; points are squares of this edge
const float in_front = 1.0 / 262144.0; // how far lines and points come forward from what they lie on, in clip space

// A line is a quad of constant width on the screen: `end` is moved across the line by half of it.
vec4 beside_line(vec4 end, vec4 other_end, float side) {
    vec2 along = (other_end.xy / other_end.w - end.xy / end.w) * frame_size;
    vec2 across = unit_or(vec3(-along.y, along.x, 0.0), vec3(0.0)).xy;
    return end + vec4(side * line_width / frame_size * end.w * across, 0.0, 0.0);
}

// Share of the line from `end` to the other end that the near plane cuts off: ends behind the camera have no place on the
// screen. The remaining part has the colours of the whole.
float hidden_share(vec4 end, vec4 other_end) {
    vec2 beyond = vec2(end.z + end.w, other_end.z + other_end.w);
    return beyond.x < 0.0 && beyond.y > 0.0 ? beyond.x / (beyond.x - beyond.y) : 0.0;
}

void main() {
    vec4 world = world_from_object * vec4(position, 1.0);
    gl_Position = clip_from_world * world;
    if (is_line) {
        vec4 other_world = world_from_object * vec4(line.xyz, 1.0);
        vec4 other_end = clip_from_world * other_world;
        float hidden = hidden_share(gl_Position, other_end);
        world = mix(world, other_world, hidden);
        gl_Position = beside_line(mix(gl_Position, other_end, hidden),
                                  mix(other_end, gl_Position, hidden_share(other_end, gl_Position)), line.w);
    }
    if (is_line || is_point) gl_Position.z -= in_front * gl_Position.w;
    gl_PointSize = line_width;
    vertex_position = world.xyz;
    vertex_normal = world_normal(normal);
    vertex_tangent = world_tangent(tangent);
    vertex_uv0 = uv0;
    vertex_uv1 = uv1;
    vertex_color = color;
}
