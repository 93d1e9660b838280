#pragma once
// Triangles, lines or points in GL buffers.
#include "gl/object.hpp"
#include "scene/scene.hpp"

namespace sr::render {

/// One mesh: its arrays one after the other in a vertex buffer, and an index buffer. Attributes that the mesh
/// lacks read as constants (white, no normal, no tangent). A line becomes a quad, which mesh.vert makes a few
/// pixels wide: core profiles need not draw lines wider than 1.
class GpuMesh {
public:
    explicit GpuMesh(const scene::Mesh& mesh);

    void draw() const;
    /// Of lines: of their quads, two each. Of points: a point.
    void draw_triangle(int triangle) const;

private:
    void draw(int first, GLsizei count) const;

    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLenum mode_;
    GLsizei index_count_ = 0;
};

} // namespace sr::render
