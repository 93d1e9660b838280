#pragma once
// Mesh of triangles, lines or points in GL buffers.
#include "gl/object.hpp"
#include "scene/scene.hpp"

#include <array>

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
    /// Lets buffer textures read the arrays of the vertices, R32F, and the indices of the corners, R32UI
    /// (shaders/interface/mesh.glsl). They are bound to the units.
    void show_arrays(const gl::Texture& floats, GLuint floats_unit, const gl::Texture& indices,
                     GLuint indices_unit) const;
    /// Returns where the array of an attribute of mesh.vert begins [floats]; -1 if the mesh has none.
    int first_float(GLuint location) const { return first_floats_[location]; }
    int float_count() const { return float_count_; }
    int triangle_count() const { return mode_ == GL_TRIANGLES ? index_count_ / 3 : 0; }

private:
    void draw(int first, GLsizei count) const;

    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLenum mode_;
    GLsizei index_count_ = 0;
    std::array<int, 7> first_floats_{}; // by location
    int float_count_ = 0;
};

} // namespace sr::render
