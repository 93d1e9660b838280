// The frame of a vertex in world space: unit vectors, because what normal maps combine must not depend on the node's scale.
#include "base/unit.glsl"
#include "interface/object.glsl"

vec3 world_normal(vec3 normal) { return unit_or(mat3(world_from_normal) * normal, vec3(0.0)); }

vec4 world_tangent(vec4 tangent) {
    return vec4(unit_or(mat3(world_from_object) * tangent.xyz, vec3(0.0)), tangent.w * handedness.x);
}
