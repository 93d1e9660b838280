#pragma once
// Triangles in GL buffers.
#include "gl/object.hpp"
#include "scene/scene.hpp"

namespace sr::render {

/// One mesh: its arrays one after the other in a vertex buffer, and an index buffer. Attributes that the mesh
/// lacks read as constants (white, no tangent).
class GpuMesh {
public:
    explicit GpuMesh(const scene::Mesh& mesh);

    void draw() const;
    void draw_triangle(int triangle) const;

private:
    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLsizei index_count_;
};

} // namespace sr::render
