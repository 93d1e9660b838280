#version 410 core
// Every triangle of the scene, from object space to the camera's clip space.
#include "base/unit.glsl"
#include "interface/frame.glsl"
#include "interface/object.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 5) in vec4 color;

out vec3 vertex_position;
out vec3 vertex_normal;
out vec4 vertex_tangent;
out vec2 vertex_uv0;
out vec2 vertex_uv1;
out vec4 vertex_color;

// The depth pre-pass and the shading pass must agree to the last bit.
invariant gl_Position;

void main() {
    vec4 world = world_from_object * vec4(position, 1.0);
    vertex_position = world.xyz;
    // Unit at the vertices in world space: what normal maps combine must not depend on the node's scale.
    vertex_normal = unit_or(mat3(world_from_normal) * normal, vec3(0.0));
    vertex_tangent = vec4(unit_or(mat3(world_from_object) * tangent.xyz, vec3(0.0)), tangent.w * handedness.x);
    vertex_uv0 = uv0;
    vertex_uv1 = uv1;
    vertex_color = color;
    gl_Position = clip_from_world * world;
}
