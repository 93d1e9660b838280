// Data of one instance. Keep in sync with ObjectBlock in src/render/gpu/blocks.hpp.
layout(std140) uniform Object {
    mat4 world_from_object;
    mat4 world_from_normal; // inverse transpose of the upper 3×3, but for a positive factor
    vec4 handedness;        // x: -1 where the transform mirrors, else 1; y: how much longer lengths become, the cube root
                            // of |det|; z: 1 where a mesh of glass is closed
    int first_triangle;     // its first triangle's index among the shadow casters
    int object;             // its own index, and its material's, in the scene
    int material;
    // The first elements of the arrays of its mesh among mesh_floats (interface/mesh.glsl); below 0: it has none.
    int first_normal;
    int first_tangent;
    int first_uv0;
    int first_uv1;
    int first_color;
};
