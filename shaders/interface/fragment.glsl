// Outputs of mesh.vert, inputs of the fragment shaders, which rasterisation interpolates. Where surfaces are shaded pixel by
// pixel, interface/seen_triangle.glsl replaces this file.
in vec3 vertex_position; // world space [m]
in vec3 vertex_normal;   // world space, unit at the vertices and interpolated; 0 at a vertex whose normal is flattened away
in vec4 vertex_tangent;  // the same of the tangent; w: handedness of the bitangent
in vec2 vertex_uv0;
in vec2 vertex_uv1;
in vec4 vertex_color;    // linear

// Gives the inputs their values, before anything reads them.
void find_fragment() {}

int triangle_of_mesh() { return gl_PrimitiveID; }

bool is_front() { return gl_FrontFacing; }

// Across the triangle, towards the viewer, of any length.
vec3 across_triangle() { return cross(dFdx(vertex_position), dFdy(vertex_position)); }

// The image at these coordinates, which are uv_from_set times a set of the vertices' and an offset.
vec4 texel_at(sampler2D image, vec2 at, mat2 uv_from_set, bool is_second_set) { return texture(image, at); }
