#pragma once
// Triangles as a PLY file that Mitsuba reads.
#include "core/math.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sr::mitsuba {

/// Three numbers a vertex under a name of their own: Mitsuba's attribute "vertex_NAME".
struct VertexAttribute {
    std::string name;
    std::vector<vec3> values;
};

/// Triangles in world space [m]. Every non-empty vertex array has positions.size() elements.
struct Triangles {
    std::vector<vec3> positions;
    std::vector<vec3> normals;
    std::vector<vec2> uv; // (0, 0) is a picture's upper left corner, as in glTF and in Mitsuba's bitmaps
    std::vector<VertexAttribute> attributes;
    std::vector<std::uint32_t> indices; // counter-clockwise seen from the front
};

/// Moves every vertex along the normal of its triangles by `distance` [m]; turned: then faces the other way.
/// Normals must be there.
Triangles moved(Triangles triangles, float distance, bool turned);

/// Binary little-endian PLY. @throws Error if the file cannot be written.
void write_ply(const Triangles& triangles, const std::filesystem::path& file);

} // namespace sr::mitsuba
