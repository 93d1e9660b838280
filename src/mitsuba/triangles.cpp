#include "mitsuba/triangles.hpp"

#include "core/error.hpp"
#include "mitsuba/new_folder.hpp"
#include "scene/transform.hpp"

#include <bit>
#include <fmt/format.h>

namespace sr::mitsuba {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY files are written as the bytes lie in memory");

/// The PLY's body.
class Bytes {
public:
    template<typename T>
    void append(const T& value) {
        const auto* first = reinterpret_cast<const char*>(&value);
        text_.append(first, sizeof(T));
    }
    std::string& text() { return text_; }

private:
    std::string text_;
};

std::string header(const Triangles& triangles) {
    std::string text =
        fmt::format("ply\nformat binary_little_endian 1.0\nelement vertex {}\n", triangles.positions.size());
    const auto property = [&](std::string_view name) { text += fmt::format("property float {}\n", name); };
    for (const char* name : {"x", "y", "z"}) property(name);
    if (!triangles.normals.empty())
        for (const char* name : {"nx", "ny", "nz"}) property(name);
    if (!triangles.uv.empty())
        for (const char* name : {"u", "v"}) property(name);
    for (const VertexAttribute& attribute : triangles.attributes)
        for (const char* axis : {"x", "y", "z"}) property(attribute.name + "_" + axis);
    text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                        triangles.indices.size() / 3);
    return text;
}

} // namespace

Triangles moved(Triangles triangles, float distance, bool turned) {
    require(triangles.normals.size() == triangles.positions.size(), "every vertex has a normal");
    for (std::size_t i = 0; i < triangles.positions.size(); ++i) {
        const vec3 n = scene::unit_or(triangles.normals[i], vec3(0.0f));
        triangles.positions[i] += distance * n;
        if (turned) triangles.normals[i] = -n;
    }
    if (turned)
        for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3)
            std::swap(triangles.indices[i], triangles.indices[i + 2]);
    return triangles;
}

void write_ply(const Triangles& triangles, const std::filesystem::path& file) {
    Bytes bytes;
    bytes.text() = header(triangles);
    for (std::size_t i = 0; i < triangles.positions.size(); ++i) {
        bytes.append(triangles.positions[i]);
        if (!triangles.normals.empty()) bytes.append(triangles.normals[i]);
        if (!triangles.uv.empty()) bytes.append(triangles.uv[i]);
        for (const VertexAttribute& attribute : triangles.attributes) bytes.append(attribute.values[i]);
    }
    for (std::size_t i = 0; i + 2 < triangles.indices.size(); i += 3) {
        bytes.append(std::uint8_t{3});
        for (std::size_t k = 0; k < 3; ++k) bytes.append(static_cast<std::int32_t>(triangles.indices[i + k]));
    }
    write_text(file, bytes.text());
}

} // namespace sr::mitsuba
