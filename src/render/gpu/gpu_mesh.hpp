#pragma once
// Mesh of triangles, lines or points in GL buffers.
#include "gl/object.hpp"
#include "scene/scene.hpp"

namespace sr::render {

/// The arrays of a mesh one after the other in a vertex buffer, and an index buffer. Attributes that the mesh
/// lacks read as constants (white, no normal, no tangent). A line becomes a quad, which mesh.vert makes a few
/// pixels wide: core profiles need not draw lines wider than 1.
class GpuMesh {
public:
    explicit GpuMesh(const scene::Mesh& mesh);

    void draw() const;
    /// Draws one triangle; of lines one of the two triangles of each quad, of points a point.
    void draw_triangle(int triangle) const;
    /// Lets buffer textures read the positions of the vertices, RGB32F, and the indices of the corners,
    /// R32UI. They are bound to the units.
    void show_corners(const gl::Texture& positions, GLuint positions_unit, const gl::Texture& indices,
                      GLuint indices_unit) const;

private:
    void draw(int first, GLsizei count) const;

    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLenum mode_;
    GLsizei index_count_ = 0;
};

} // namespace sr::render
