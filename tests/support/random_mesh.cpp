#include "support/random_parts.hpp"

#include <algorithm>

namespace sr::testing {
namespace {

using glm::dvec2;
using glm::dvec3;

/// Vertices and triangles on their way into a primitive.
struct Shape {
    std::vector<dvec3> positions;
    std::vector<dvec3> normals; // those of the true surface
    std::vector<dvec2> uv;
    std::vector<std::uint16_t> indices;

    /// A grid of cells² squares, p(s, t) for s and t in [0, 1], its front where s × t points.
    template<class Position>
    void append_grid(int cells, const Position& p) {
        const auto first = static_cast<int>(positions.size());
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i) {
                const double s = static_cast<double>(i) / cells, t = static_cast<double>(j) / cells;
                positions.push_back(p(s, t));
                constexpr double h = 1e-4;
                normals.push_back(
                    glm::normalize(glm::cross(p(s + h, t) - p(s - h, t), p(s, t + h) - p(s, t - h))));
                uv.emplace_back(s, t);
            }
        const auto corner = [&](int i, int j) {
            return static_cast<std::uint16_t>(first + j * (cells + 1) + i);
        };
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i)
                indices.insert(indices.end(), {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                               corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
};

dvec3 on_ball(double s, double t) {
    // The poles are left out: there s has no direction.
    const double phi = 6.283185307179586 * s, theta = 0.05 + 3.04 * (1.0 - t);
    return {std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi)};
}

Shape shape_of(Form form, Random& random) {
    Shape shape;
    const double wave = random.within(0.0, 0.3), phase = random.within(0.0, 6.0);
    switch (form) {
    case Form::ground:
    case Form::quad:
        shape.append_grid(1, [](double s, double t) { return dvec3(2.0 * s - 1.0, 2.0 * t - 1.0, 0.0); });
        break;
    case Form::box:
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
                shape.append_grid(1, [&](double s, double t) {
                    dvec3 p(0.0);
                    p[axis] = side;
                    p[(axis + 1) % 3] = 2.0 * s - 1.0;
                    p[(axis + 2) % 3] = side * (2.0 * t - 1.0);
                    return p;
                });
        break;
    case Form::ball: shape.append_grid(10, on_ball); break;
    default: // a bumpy sheet, and loose triangles around
        shape.append_grid(6, [&](double s, double t) {
            return dvec3(2.0 * s - 1.0, 2.0 * t - 1.0, wave * std::sin(7.0 * s + 5.0 * t + phase));
        });
        for (int i = 0; i < 4; ++i) {
            const dvec3 at = random.in_cube(1.0), u = 0.5 * random.direction(), v = 0.5 * random.direction();
            shape.append_grid(1, [&](double s, double t) { return at + s * u + t * v; });
        }
    }
    return shape;
}

std::vector<float> floats_of(const std::vector<dvec3>& vectors) {
    std::vector<float> result;
    for (const dvec3& v : vectors)
        for (int i = 0; i < 3; ++i) result.push_back(static_cast<float>(v[i]));
    return result;
}

dvec3 across(const dvec3& n, double angle) {
    const dvec3 t = glm::normalize(glm::cross(n, std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    return std::cos(angle) * t + std::sin(angle) * glm::cross(n, t);
}

/// Triangles without area, of one vertex, of two, and of three on a line; vectors of no length.
void degenerate(Shape& shape, Random& random) {
    const auto vertex = [&] {
        return static_cast<std::uint16_t>(random.below(static_cast<int>(shape.positions.size())));
    };
    for (int i = 0; i < 6; ++i) {
        const std::uint16_t a = vertex(), b = vertex();
        shape.indices.insert(shape.indices.end(), {a, b, a});
        shape.indices.insert(shape.indices.end(), {b, b, b});
        shape.normals[vertex()] = random.has_chance(0.5) ? dvec3(0.0) : -shape.normals[a];
        shape.positions[vertex()] = shape.positions[vertex()];
        shape.uv[vertex()] = shape.uv[vertex()];
    }
}

/// Returns whether the BRDF has a roughness across the tangent.
bool has_width_across(Surface surface) {
    const auto model = model_of(surface);
    return model && std::ranges::any_of(scene::brdf_parameters, [&](const scene::BrdfParameter& parameter) {
               return parameter.is_of(*model) && parameter.key == "roughness_across";
           });
}

/// Returns whether the surface reads tangents, which the file may then state.
bool has_tangents(Surface surface) {
    return surface == Surface::textured || surface == Surface::mapped || surface == Surface::anisotropic
           || surface == Surface::coated || has_width_across(surface);
}

/// Two morph targets, of which a weight is stated.
void append_targets(MadeGltf& made, json& mesh, std::size_t vertices, Random& random) {
    for (int target = 0; target < 2; ++target) {
        std::vector<dvec3> moved(vertices);
        for (dvec3& v : moved) v = random.in_cube(0.1);
        mesh["primitives"][0]["targets"].push_back({{"POSITION", made.floats(floats_of(moved), "VEC3")}});
        mesh["weights"].push_back(random.within(0.0, 1.0));
    }
}

} // namespace

int append_mesh(MadeGltf& made, Form form, Surface surface, int material, Random& random,
                const Extremes& extremes) {
    Shape shape = shape_of(form, random);
    if (extremes.has_degenerate_meshes) degenerate(shape, random);
    json primitive;
    json& attributes = primitive["attributes"];
    attributes["POSITION"] = made.floats(floats_of(shape.positions), "VEC3");
    const bool has_normals = extremes.has_degenerate_meshes || random.has_chance(0.8);
    if (has_normals) attributes["NORMAL"] = made.floats(floats_of(shape.normals), "VEC3");
    for (const char* name : {"TEXCOORD_0", "TEXCOORD_1"}) {
        std::vector<float> uv;
        const double u = random.within(-1.0, 1.0), v = random.within(0.3, 2.0);
        for (const dvec2& at : shape.uv)
            uv.insert(uv.end(), {static_cast<float>(u + v * at.x), static_cast<float>(v * at.y)});
        attributes[name] = made.floats(uv, "VEC2");
    }
    if (has_normals && has_tangents(surface) && random.has_chance(0.5)) {
        std::vector<float> tangents;
        const double angle = random.within(0.0, 6.0), w = random.has_chance(0.5) ? -1.0 : 1.0;
        for (const dvec3& n : shape.normals) {
            const dvec3 t = glm::length(n) > 0.0 ? across(n, angle) : dvec3(0.0);
            for (const double value : {t.x, t.y, t.z, w}) tangents.push_back(static_cast<float>(value));
        }
        attributes["TANGENT"] = made.floats(tangents, "VEC4");
    }
    if (surface == Surface::colored) {
        std::vector<float> colors;
        for (std::size_t i = 0; i < 3 * shape.positions.size(); ++i)
            colors.push_back(static_cast<float>(random.within(0.2, 1.0)));
        attributes["COLOR_0"] = made.floats(colors, "VEC3");
    }
    primitive["indices"] = made.shorts(shape.indices);
    primitive["material"] = material;
    json mesh{{"primitives", json::array({primitive})}};
    if (surface != Surface::glowing_quad && random.has_chance(0.15))
        append_targets(made, mesh, shape.positions.size(), random);
    made.root["meshes"].push_back(mesh);
    return static_cast<int>(made.root["meshes"].size()) - 1;
}

} // namespace sr::testing
