#include "picture/illuminance.hpp"

#include "core/error.hpp"
#include "output/isolines.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <sstream>
#include <utility>

namespace sr::picture {
namespace {

/// "X,Y,Z"; absent if it is anything else.
std::optional<glm::dvec3> parse_triple(const std::string& text) {
    std::istringstream stream(text);
    std::vector<double> numbers;
    for (std::string part; std::getline(stream, part, ',');) {
        const auto number = settings::parse_number(part);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    if (numbers.size() != 3) return std::nullopt;
    return glm::dvec3(numbers[0], numbers[1], numbers[2]);
}

/// Leaves out a border of `width` metres on all sides.
scene::Receiver without_border(scene::Receiver receiver, float width) {
    const vec3 along_u = glm::normalize(receiver.u) * width, along_v = glm::normalize(receiver.v) * width;
    receiver.corner += along_u + along_v;
    receiver.u -= 2.0f * along_u;
    receiver.v -= 2.0f * along_v;
    return receiver;
}

render::RenderOptions cell_options(render::RenderOptions options) {
    options.shader = "views/irradiance.frag";
    options.estimates_error = false;
    return options;
}

} // namespace

StatedPlane parse_plane(const std::string& text) {
    std::vector<glm::dvec3> triples;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ';');)
        if (const auto triple = parse_triple(part))
            triples.push_back(*triple);
        else
            triples.resize(4); // too many
    if (triples.size() != 3)
        throw Error(fmt::format("'{}' is not a corner and two edges", text),
                    "write them as 0,0.8,0;4,0,0;0,0,-3");
    const StatedPlane plane{triples[0], vec3(triples[1]), vec3(triples[2])};
    const float area = glm::length(glm::cross(plane.u, plane.v));
    const float lengths = glm::length(plane.u) * glm::length(plane.v);
    if (!(lengths > 0.0f) || !(area > (1.0f - 1e-6f) * lengths))
        throw Error(fmt::format("the edges of '{}' are not perpendicular", text),
                    "choose edges of a rectangle");
    return plane;
}

scene::Receiver receiver_of(const ReceiverChoice& choice, const scene::Scene& scene,
                            const std::string& file) {
    scene::Receiver receiver;
    if (choice.plane) {
        receiver = {vec3(choice.plane->corner - scene.origin), choice.plane->u, choice.plane->v};
    } else {
        const scene::Bounds bounds = scene::bounds_of(scene);
        if (bounds.is_empty())
            throw Error({file}, "nothing is in the scene that a plane could be fitted to",
                        "state one with --plane");
        receiver = scene::horizontal_receiver(bounds, static_cast<float>(choice.height));
    }
    const float width = glm::length(receiver.u), height = glm::length(receiver.v);
    const auto border = static_cast<float>(choice.border);
    if (!(std::min(width, height) > 2.0f * border))
        throw Error({file},
                    fmt::format("the plane of {:.4g} × {:.4g} m has no area{}", width, height,
                                border > 0.0f ? " within its border" : ""),
                    "choose a larger one (--plane), or a smaller border (--border)");
    return border > 0.0f ? without_border(receiver, border) : receiver;
}

settings::Size cells_of(const scene::Receiver& receiver, std::optional<double> spacing) {
    const double width = glm::length(receiver.u), height = glm::length(receiver.v);
    const double side = spacing.value_or(std::max(width, height) / default_cells);
    const auto count = [&](double length) {
        const double cells = std::max(1.0, std::ceil(length / side - 1e-6));
        if (cells > max_cells)
            throw Error(fmt::format("{:.4g} m makes {:.0f} cells of {:.4g} m", side, cells, length),
                        fmt::format("choose {:.2g} m or more", length / max_cells));
        return static_cast<int>(cells);
    };
    return {count(width), count(height)};
}

std::vector<output::PlanMark> marks_of(const std::vector<scene::Light>& lights,
                                       const scene::Receiver& receiver) {
    std::vector<output::PlanMark> marks;
    for (const scene::Light& light : lights) {
        const auto center = scene::center_of(light);
        if (!center) continue;
        const vec3 offset = *center - receiver.corner;
        const vec2 place(glm::dot(offset, receiver.u) / glm::dot(receiver.u, receiver.u),
                         glm::dot(offset, receiver.v) / glm::dot(receiver.v, receiver.v));
        if (place.x >= 0.0f && place.x <= 1.0f && place.y >= 0.0f && place.y <= 1.0f)
            marks.push_back({place, scene::name_of(light)});
    }
    return marks;
}

std::string plan_of(const output::IlluminanceGrid& grid, std::vector<double> levels,
                    const std::vector<scene::Light>& lights, const std::string& file) {
    const output::IlluminanceSummary summary = output::summary_of(grid);
    if (levels.empty()) levels = output::round_levels(summary.min, summary.max, isoline_count);
    return output::plan_svg(grid, levels, marks_of(lights, grid.receiver),
                            std::filesystem::path(file).filename().string());
}

IlluminanceRender::IlluminanceRender(scene::RenderScene stage, const scene::Receiver& receiver,
                                     const settings::RenderSettings& settings,
                                     const render::RenderOptions& rendering)
    : stage_(std::move(stage)),
      receiver_(receiver),
      camera_(scene::add_receiver(stage_.scene, receiver)),
      gpu_(stage_.scene, stage_.lights, settings.visibility, settings.has_energy_compensation),
      renderer_(gpu_, camera_, cell_options(rendering)) {}

void IlluminanceRender::begin(int first, int end) {
    renderer_.clear();
    renderer_.use_lights(first, end);
}

std::string IlluminanceRender::name_of_light(int index) const {
    const std::string& name = scene::name_of(stage_.lights[static_cast<std::size_t>(index)]);
    return name.empty() ? fmt::format("light {}", index) : name;
}

output::IlluminanceGrid IlluminanceRender::grid() const {
    output::IlluminanceGrid grid = output::illuminance_of(renderer_.read_film(), receiver_);
    grid.origin = stage_.scene.origin;
    grid.unit = scene::name_of({scene::Quantity::irradiance, stage_.scene.units});
    return grid;
}

} // namespace sr::picture
