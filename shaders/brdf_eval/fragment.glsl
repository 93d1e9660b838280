// The place of interface/fragment.glsl where there is no mesh: one tilted frame, white.
const vec3 tilted_n = vec3(0.48, -0.6, 0.64);
const vec3 tilted_t = normalize(cross(vec3(0.0, 0.0, 1.0), tilted_n));

const vec3 vertex_position = vec3(0.0);
const vec3 vertex_normal = tilted_n;
const vec4 vertex_tangent = vec4(tilted_t, 1.0);
const vec2 vertex_uv0 = vec2(0.0);
const vec2 vertex_uv1 = vec2(0.0);
const vec4 vertex_color = vec4(1.0);

bool is_front() { return true; }
vec3 across_triangle() { return tilted_n; }
vec4 texel_at(sampler2D image, vec2 at, mat2 uv_from_set, bool is_second_set) { return texture(image, at); }
