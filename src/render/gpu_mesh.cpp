#include "render/gpu_mesh.hpp"

#include <array>

namespace sr::render {
namespace {

/// A vertex array of the mesh, as bytes, and where mesh.vert reads it.
struct Attribute {
    GLuint location;
    GLint components;
    const void* data;
    std::size_t bytes;
};

template<class T>
Attribute attribute(GLuint location, const std::vector<T>& values) {
    return {location, static_cast<GLint>(sizeof(T) / sizeof(float)), values.data(),
            values.size() * sizeof(T)};
}

} // namespace

GpuMesh::GpuMesh(const scene::Mesh& mesh)
    : vertex_array_(mesh.name),
      vertices_(mesh.name),
      indices_(mesh.name),
      index_count_(static_cast<GLsizei>(mesh.indices.size())) {
    const std::array attributes{attribute(0, mesh.positions),    attribute(1, mesh.normals),
                                attribute(2, mesh.tangents),     attribute(3, mesh.texcoords[0]),
                                attribute(4, mesh.texcoords[1]), attribute(5, mesh.colors)};
    std::size_t total = 0;
    for (const Attribute& a : attributes) total += a.bytes;

    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr, GL_STATIC_DRAW);
    std::size_t offset = 0;
    for (const Attribute& a : attributes) {
        if (a.bytes == 0) continue;
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(a.bytes),
                        a.data);
        glEnableVertexAttribArray(a.location);
        glVertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, 0,
                              reinterpret_cast<const void*>(offset));
        offset += a.bytes;
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(mesh.indices[0])), mesh.indices.data(),
                 GL_STATIC_DRAW);
}

void GpuMesh::draw() const {
    glBindVertexArray(vertex_array_.id());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void GpuMesh::draw_triangle(int triangle) const {
    glBindVertexArray(vertex_array_.id());
    const std::size_t offset = 3 * static_cast<std::size_t>(triangle) * sizeof(std::uint32_t);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

} // namespace sr::render
