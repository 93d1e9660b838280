#include "output/illuminance.hpp"

#include "core/math.hpp"
#include "image/colormap.hpp"
#include "output/variables.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace sr::output {
namespace {

/// Adds the plane to the scene, as a surface that the camera alone sees.
void add_surface(scene::Scene& scene, vec3 center, vec2 half) {
    scene::Mesh mesh;
    mesh.name = "measuring plane";
    mesh.positions = {center + vec3(-half.x, 0, half.y), center + vec3(half.x, 0, half.y),
                      center + vec3(half.x, 0, -half.y), center + vec3(-half.x, 0, -half.y)};
    mesh.normals.assign(4, vec3(0.0f, 1.0f, 0.0f));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = static_cast<int>(scene.materials.size());
    scene.materials.emplace_back();
    scene.instances.push_back({static_cast<int>(scene.meshes.size()), mat4(1.0f), mesh.name});
    scene.meshes.push_back(std::move(mesh));
}

/// A camera just above the plane that sees nothing else: x to the right, z down.
scene::Camera camera_over(vec3 center, vec2 half) {
    const float above = 1e-3f * std::max(half.x, half.y);
    const vec3 eye = center + vec3(0.0f, above, 0.0f);
    scene::Camera camera;
    camera.name = "measuring plane";
    camera.world_from_camera = mat4(vec4(1, 0, 0, 0), vec4(0, 0, -1, 0), vec4(0, 1, 0, 0), vec4(eye, 1.0f));
    camera.projection = scene::Orthographic{half.x, half.y, 0.5f * above, 2.0f * above};
    return camera;
}

/// Bilinear between the centres of cells; `at` in cells from the corner.
double interpolated(const IlluminanceTable& table, glm::dvec2 at) {
    const glm::dvec2 last(table.plane.columns - 1, table.plane.rows - 1);
    const glm::dvec2 p = glm::clamp(at - 0.5, glm::dvec2(0.0), last);
    const glm::dvec2 low = glm::min(glm::floor(p), glm::max(last - 1.0, glm::dvec2(0.0))), t = p - low;
    const auto value = [&](double x, double y) {
        return static_cast<double>(
            table.at(static_cast<int>(std::min(x, last.x)), static_cast<int>(std::min(y, last.y))));
    };
    return glm::mix(glm::mix(value(low.x, low.y), value(low.x + 1.0, low.y), t.x),
                    glm::mix(value(low.x, low.y + 1.0), value(low.x + 1.0, low.y + 1.0), t.x), t.y);
}

} // namespace

glm::dvec2 MeasuringPlane::center_of(int column, int row) const {
    return from + (to - from) * (glm::dvec2(column, row) + 0.5) / glm::dvec2(columns, rows);
}

double IlluminanceTable::min() const { return *std::ranges::min_element(values); }
double IlluminanceTable::max() const { return *std::ranges::max_element(values); }
double IlluminanceTable::mean() const {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}
double IlluminanceTable::uniformity() const { return mean() > 0.0 ? min() / mean() : 0.0; }

IlluminanceTable illuminance_on(const MeasuringPlane& plane, scene::RenderScene stage,
                                render::Visibility visibility, render::RenderOptions options) {
    const glm::dvec2 middle = 0.5 * (plane.from + plane.to);
    const vec3 center(glm::dvec3(middle.x, plane.height, middle.y) - stage.scene.origin);
    const vec2 half(0.5 * (plane.to - plane.from));
    add_surface(stage.scene, center, half);
    const render::GpuScene scene(stage.scene, stage.lights, visibility);
    options.width = plane.columns;
    options.height = plane.rows;
    options.shader = view_named("irradiance")->shader;
    options.estimator = render::Estimator::sampled;
    options.estimates_error = false;
    render::Renderer renderer(scene, camera_over(center, half), options);
    for (int i = 0; i < options.samples; ++i) renderer.add_sample();
    const image::Image film = renderer.read_film();
    IlluminanceTable table{plane, {}};
    for (int row = 0; row < plane.rows; ++row)
        for (int column = 0; column < plane.columns; ++column) {
            const auto E = film.at(column, row);
            table.values.push_back(luminance(E[0], E[1], E[2]));
        }
    return table;
}

std::string csv_of(const IlluminanceTable& table, scene::UnitSystem units) {
    std::string text = fmt::format("x [m],y [m],z [m],E [{}]\n", unit_of(view_named("irradiance"), units));
    for (int row = 0; row < table.plane.rows; ++row)
        for (int column = 0; column < table.plane.columns; ++column) {
            const glm::dvec2 at = table.plane.center_of(column, row);
            text += fmt::format("{:.9g},{:.9g},{:.9g},{:.6g}\n", at.x, table.plane.height, at.y,
                                table.at(column, row));
        }
    return text;
}

std::vector<double> isoline_levels(const IlluminanceTable& table) {
    const double low = table.min(), high = table.max();
    std::vector<double> levels;
    if (!(high > low)) return levels;
    constexpr double most = 10.0;
    const double power = std::pow(10.0, std::floor(std::log10((high - low) / most)));
    double step = power;
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        step = factor * power;
        if ((high - low) / step <= most) break;
    }
    for (double k = std::floor(low / step) + 1.0; k * step < high && levels.size() < 10; ++k)
        levels.push_back(k * step);
    return levels;
}

image::Image isoline_picture(const IlluminanceTable& table, int pixels) {
    const glm::dvec2 size = table.plane.to - table.plane.from;
    const glm::dvec2 shape = glm::round(static_cast<double>(pixels) * size / std::max(size.x, size.y));
    image::Image picture(std::max(1, static_cast<int>(shape.x)), std::max(1, static_cast<int>(shape.y)), 3);
    const std::vector<double> levels = isoline_levels(table);
    const double high = table.max();
    const auto value = [&](int x, int y) {
        const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) / glm::dvec2(picture.width, picture.height);
        return interpolated(table, place * glm::dvec2(table.plane.columns, table.plane.rows));
    };
    const auto band = [&](double E) { return std::ranges::upper_bound(levels, E) - levels.begin(); };
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const double E = value(x, y);
            const bool is_line = band(E) != band(value(x + 1, y)) || band(E) != band(value(x, y + 1));
            const vec3 color =
                is_line ? vec3(0.0f) : image::colormap(high > 0.0 ? static_cast<float>(E / high) : 0.0f);
            for (int c = 0; c < 3; ++c) picture.at(x, y)[static_cast<std::size_t>(c)] = color[c];
        }
    return picture;
}

} // namespace sr::output
