// The place of interface/fragment.glsl where a surface is shaded pixel by pixel: what rasterisation would interpolate is found
// in the triangle that the pixel sees (a visibility buffer: Burns & Hunt 2013).
#include "interface/features.glsl"
#include "interface/frame.glsl"
#include "interface/mesh.glsl"
#include "surface/vertex.glsl"

uniform isampler2D seen_triangles; // of each pixel, counted within its mesh

vec3 vertex_position;
vec3 vertex_normal;
vec4 vertex_tangent;
vec2 vertex_uv0;
vec2 vertex_uv1;
vec4 vertex_color;

int seen_triangle;
bool is_counterclockwise;
mat3 corner_positions; // world space [m]
vec3 clip_x, clip_y, clip_w; // of the corners
mat2 uv0_slopes, uv1_slopes; // by a pixel to the right, and by one up

// The weights of the corners at a place of the picture [pixels], up to a factor that is positive where they lie
// counterclockwise. In homogeneous coordinates no corner needs to lie before the camera (Olano & Greer 1997).
// Coordinates relative to the place keep small triangles exact.
vec3 unscaled_weights(vec2 place) {
    vec2 p = 2.0 * place / frame_size - 1.0;
    vec3 x = clip_x - p.x * clip_w, y = clip_y - p.y * clip_w;
    return x.yzx * y.zxy - x.zxy * y.yzx;
}

vec3 scaled(vec3 weights) {
    float sum = weights.x + weights.y + weights.z;
    return sum != 0.0 ? weights / sum : vec3(1.0 / 3.0);
}

// Of the two by two pixels that a driver takes slopes from.
void find_slopes(mat3x2 uv0, mat3x2 uv1) {
    vec2 place = 2.0 * floor(0.5 * gl_FragCoord.xy) + 0.5;
    vec3 here = scaled(unscaled_weights(place));
    vec3 right = scaled(unscaled_weights(place + vec2(1.0, 0.0))) - here;
    vec3 up = scaled(unscaled_weights(place + vec2(0.0, 1.0))) - here;
    uv0_slopes = mat2(uv0 * right, uv0 * up);
    uv1_slopes = mat2(uv1 * right, uv1 * up);
}

mat3x2 corner_uvs(int first, ivec3 v) {
    return first < 0 ? mat3x2(0.0) : mat3x2(mesh_vec2(first, v.x), mesh_vec2(first, v.y), mesh_vec2(first, v.z));
}

vec3 corner_normal(int vertex) {
    return world_normal(first_normal < 0 ? vec3(0.0) : mesh_vec3(first_normal, vertex));
}

vec4 corner_tangent(int vertex) {
    return world_tangent(first_tangent < 0 ? vec4(0.0, 0.0, 0.0, 1.0) : mesh_vec4(first_tangent, vertex));
}

void find_fragment() {
    seen_triangle = texelFetch(seen_triangles, ivec2(gl_FragCoord.xy), 0).r;
    ivec3 v = ivec3(vertex_of(seen_triangle, 0), vertex_of(seen_triangle, 1), vertex_of(seen_triangle, 2));
    corner_positions = mat3(corner_position(v.x), corner_position(v.y), corner_position(v.z));
    mat3x4 clip = clip_from_world * mat3x4(vec4(corner_positions[0], 1.0), vec4(corner_positions[1], 1.0),
                                           vec4(corner_positions[2], 1.0));
    clip_x = vec3(clip[0].x, clip[1].x, clip[2].x);
    clip_y = vec3(clip[0].y, clip[1].y, clip[2].y);
    clip_w = vec3(clip[0].w, clip[1].w, clip[2].w);
    vec3 weights = unscaled_weights(gl_FragCoord.xy);
    is_counterclockwise = weights.x + weights.y + weights.z > 0.0;
    // A pixel on an edge may lie outside by the driver's rounding.
    weights = scaled(is_counterclockwise ? max(weights, 0.0) : min(weights, 0.0));

    mat3x2 uv0 = corner_uvs(first_uv0, v);
    mat3x2 uv1 = has_second_uv ? corner_uvs(first_uv1, v) : mat3x2(0.0);
    vertex_position = corner_positions * weights;
    vertex_normal = mat3(corner_normal(v.x), corner_normal(v.y), corner_normal(v.z)) * weights;
    vertex_tangent = mat3x4(corner_tangent(v.x), corner_tangent(v.y), corner_tangent(v.z)) * weights;
    vertex_uv0 = uv0 * weights;
    vertex_uv1 = uv1 * weights;
    if (has_vertex_colors)
        vertex_color = mat3x4(mesh_vec4(first_color, v.x), mesh_vec4(first_color, v.y), mesh_vec4(first_color, v.z))
                       * weights;
    find_slopes(uv0, uv1);
}

int triangle_of_mesh() { return seen_triangle; }

bool is_front() { return is_counterclockwise == (handedness.x > 0.0); }

vec3 across_triangle() {
    vec3 across = cross(corner_positions[1] - corner_positions[0], corner_positions[2] - corner_positions[0]);
    return is_counterclockwise ? across : -across;
}

vec4 texel_at(sampler2D image, vec2 at, mat2 uv_from_set, bool is_second_set) {
    mat2 slopes = uv_from_set * (is_second_set ? uv1_slopes : uv0_slopes);
    return textureGrad(image, at, slopes[0], slopes[1]);
}
