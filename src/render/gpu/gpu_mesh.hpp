#pragma once
// Mesh of triangles, lines or points in GL buffers.
#include "gl/object.hpp"
#include "render/gpu/gpu_texture.hpp"
#include "scene/scene.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace sr::render {

/// Some triangles of a mesh.
class TriangleSelection {
public:
    /// `triangles`: their numbers; `indices`: of the whole mesh, three a triangle.
    /// @throws Error if the driver's buffer textures are too small
    TriangleSelection(const std::vector<std::uint32_t>& triangles, std::span<const std::uint32_t> indices);

    /// Lets shaders read the number that each triangle has in the mesh, R32UI.
    void show_numbers(GLuint unit) const { numbers_.bind(unit); }

private:
    friend class GpuMesh;
    gl::Buffer indices_{"indices of some triangles"};
    BufferTexture numbers_{"numbers of some triangles", GL_R32UI};
    GLsizei index_count_ = 0;
};

/// The arrays of a mesh one after the other in a vertex buffer, and an index buffer. Attributes that the mesh
/// lacks read as constants (white, no normal, no tangent). A line becomes a quad, which mesh.vert makes a few
/// pixels wide: core profiles need not draw lines wider than 1.
class GpuMesh {
public:
    explicit GpuMesh(const scene::Mesh& mesh);

    void draw() const;
    /// Draws one triangle; of lines one of the two triangles of each quad, of points a point.
    void draw_triangle(int triangle) const;
    /// Draws some of its triangles, whose corners `indices` names.
    void draw(const TriangleSelection& triangles) const;
    /// Read back where its vertices are, and the corners of its triangles. Not of lines and points.
    std::vector<vec3> read_positions() const;
    std::vector<std::uint32_t> read_indices() const;
    /// Lets buffer textures read the arrays of the vertices, R32F, and the indices of the corners, R32UI
    /// (shaders/interface/mesh.glsl). They are bound to the units.
    void show_arrays(const gl::Texture& floats, GLuint floats_unit, const gl::Texture& indices,
                     GLuint indices_unit) const;
    /// Returns where the array of an attribute of mesh.vert begins [floats]; -1 if the mesh has none.
    int first_float(GLuint location) const { return first_floats_[location]; }
    int float_count() const { return float_count_; }
    int triangle_count() const { return mode_ == GL_TRIANGLES ? index_count_ / 3 : 0; }

private:
    void draw(const gl::Buffer& indices, int first, GLsizei count) const;

    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    GLenum mode_;
    GLsizei index_count_ = 0;
    std::array<int, 7> first_floats_{}; // by location
    int float_count_ = 0;
    std::size_t vertex_count_ = 0;
};

} // namespace sr::render
