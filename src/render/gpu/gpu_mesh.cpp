#include "render/gpu/gpu_mesh.hpp"

#include <array>
#include <optional>
#include <tuple>
#include <utility>

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

template<class T>
void take(std::vector<T>& values, const std::vector<T>& from, const std::vector<std::uint32_t>& vertices) {
    if (from.empty()) return;
    for (const std::uint32_t v : vertices) values.push_back(from[v]);
}

/// Quads of no width along the lines, and for each vertex the line's other end and its side.
struct Quads {
    scene::Mesh mesh;
    std::vector<vec4> others;

    explicit Quads(const scene::Mesh& lines) {
        std::vector<std::uint32_t> vertices;
        for (std::size_t i = 0; i + 1 < lines.lines.size(); i += 2) {
            const std::uint32_t a = lines.lines[i], b = lines.lines[i + 1];
            const auto first = static_cast<std::uint32_t>(vertices.size());
            // Seen from the other end, sides change places.
            for (const auto& [end, other, side] : {std::tuple(a, b, 1.0f), std::tuple(a, b, -1.0f),
                                                   std::tuple(b, a, 1.0f), std::tuple(b, a, -1.0f)}) {
                vertices.push_back(end);
                others.emplace_back(lines.positions[other], side);
            }
            for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
                mesh.indices.push_back(first + corner);
        }
        take(mesh.positions, lines.positions, vertices);
        take(mesh.normals, lines.normals, vertices);
        take(mesh.tangents, lines.tangents, vertices);
        for (std::size_t set = 0; set < 2; ++set) take(mesh.texcoords[set], lines.texcoords[set], vertices);
        take(mesh.colors, lines.colors, vertices);
    }
};

void upload_indices(const gl::Buffer& buffer, std::span<const std::uint32_t> indices) {
    // An index buffer that is bound as one belongs to a vertex array.
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer.id());
    glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                 GL_STATIC_DRAW);
}

template<class T>
std::vector<T> read_first(const gl::Buffer& buffer, std::size_t count) {
    std::vector<T> elements(count);
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(T)), elements.data());
    return elements;
}

} // namespace

TriangleSelection::TriangleSelection(const std::vector<std::uint32_t>& triangles,
                                     std::span<const std::uint32_t> indices)
    : index_count_(static_cast<GLsizei>(3 * triangles.size())) {
    std::vector<std::uint32_t> selected;
    selected.reserve(3 * triangles.size());
    for (const std::uint32_t triangle : triangles) {
        const auto corners = indices.subspan(std::size_t{3} * triangle, 3);
        selected.insert(selected.end(), corners.begin(), corners.end());
    }
    upload_indices(indices_, selected);
    numbers_.upload(triangles, "use a mesh of fewer triangles");
}

GpuMesh::GpuMesh(const scene::Mesh& source)
    : vertex_array_(source.name),
      vertices_(source.name),
      indices_(source.name),
      mode_(source.points.empty() ? GL_TRIANGLES : GL_POINTS) {
    std::optional<Quads> quads;
    if (!source.lines.empty()) quads.emplace(source);
    const scene::Mesh& mesh = quads ? quads->mesh : source;
    const std::vector<vec4> no_others;
    const std::vector<vec4>& others = quads ? std::as_const(quads->others) : no_others;
    const std::vector<std::uint32_t>& indices = mesh.points.empty() ? mesh.indices : mesh.points;
    index_count_ = static_cast<GLsizei>(indices.size());
    const std::array attributes{attribute(0, mesh.positions),
                                attribute(1, mesh.normals),
                                attribute(2, mesh.tangents),
                                attribute(3, mesh.texcoords[0]),
                                attribute(4, mesh.texcoords[1]),
                                attribute(5, mesh.colors),
                                attribute(6, others)};
    std::size_t total = 0;
    for (const Attribute& a : attributes) total += a.bytes;

    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(total), nullptr, GL_STATIC_DRAW);
    std::size_t offset = 0;
    first_floats_.fill(-1);
    float_count_ = static_cast<int>(total / sizeof(float));
    for (const Attribute& a : attributes) {
        if (a.bytes == 0) continue;
        first_floats_[a.location] = static_cast<int>(offset / sizeof(float));
        glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(a.bytes),
                        a.data);
        glEnableVertexAttribArray(a.location);
        glVertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, 0,
                              reinterpret_cast<const void*>(offset));
        offset += a.bytes;
    }
    upload_indices(indices_, indices);
    vertex_count_ = mesh.positions.size();
}

void GpuMesh::draw() const { draw(indices_, 0, index_count_); }

void GpuMesh::draw(const TriangleSelection& triangles) const {
    draw(triangles.indices_, 0, triangles.index_count_);
}

std::vector<vec3> GpuMesh::read_positions() const { return read_first<vec3>(vertices_, vertex_count_); }

std::vector<std::uint32_t> GpuMesh::read_indices() const {
    return read_first<std::uint32_t>(indices_, static_cast<std::size_t>(index_count_));
}

void GpuMesh::draw_triangle(int triangle) const {
    const GLsizei corners = mode_ == GL_POINTS ? 1 : 3;
    draw(indices_, corners * triangle, corners);
}

void GpuMesh::show_arrays(const gl::Texture& floats, GLuint floats_unit, const gl::Texture& indices,
                          GLuint indices_unit) const {
    floats.bind(floats_unit);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, vertices_.id());
    indices.bind(indices_unit);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_R32UI, indices_.id());
}

void GpuMesh::draw(const gl::Buffer& indices, int first, GLsizei count) const {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    if (mode_ == GL_POINTS) glEnable(GL_PROGRAM_POINT_SIZE); // nothing else is drawn as points
    const std::size_t offset = static_cast<std::size_t>(first) * sizeof(std::uint32_t);
    glDrawElements(mode_, count, GL_UNSIGNED_INT, reinterpret_cast<const void*>(offset));
}

} // namespace sr::render
