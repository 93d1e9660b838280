// What mesh.vert hands to the fragment shaders.
in vec3 vertex_position; // world space [m]
in vec3 vertex_normal;   // world space, length as interpolated
in vec4 vertex_tangent;  // world space; w: handedness of the bitangent
in vec2 vertex_uv0;
in vec2 vertex_uv1;
in vec4 vertex_color;    // linear
