// Outputs of mesh.vert, inputs of the fragment shaders.
in vec3 vertex_position; // world space [m]
in vec3 vertex_normal;   // world space, unit at the vertices and interpolated; 0 at a vertex whose normal is flattened away
in vec4 vertex_tangent;  // the same of the tangent; w: handedness of the bitangent
in vec2 vertex_uv0;
in vec2 vertex_uv1;
in vec4 vertex_color;    // linear
