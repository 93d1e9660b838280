// The place of interface/fragment.glsl where there is no mesh: one tilted frame, white.
const vec3 tilted_n = vec3(0.48, -0.6, 0.64);
const vec3 tilted_t = normalize(cross(vec3(0.0, 0.0, 1.0), tilted_n));

const vec3 vertex_position = vec3(0.0);
const vec3 vertex_normal = tilted_n;
const vec4 vertex_tangent = vec4(tilted_t, 1.0);
const vec2 vertex_uv0 = vec2(0.0);
const vec2 vertex_uv1 = vec2(0.0);
const vec4 vertex_color = vec4(1.0);
