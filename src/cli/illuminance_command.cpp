#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "image/whole_file.hpp"
#include "output/illuminance.hpp"
#include "output/illuminance_plan.hpp"
#include "output/isolines.hpp"
#include "picture/open_scene.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;
using output::IlluminanceGrid;

constexpr int longest_side = 64; // cells, where neither --grid nor --spacing is given
constexpr int max_cells = 4096;  // along a side: the size of a picture that every driver takes
constexpr int isoline_count = 10;

/// The receiver that --plane states, in the file's world.
struct StatedPlane {
    glm::dvec3 corner{0.0};
    vec3 u{0.0f};
    vec3 v{0.0f};
};

struct IlluminanceCommand {
    RenderSettings settings;
    std::vector<std::string> outputs; // .svg or .csv
    std::optional<StatedPlane> plane;
    double height = 0.8; // [m], above the lowest point
    double border = 0.0; // [m]
    std::optional<Size> grid;
    std::optional<double> spacing; // [m]
    std::vector<double> levels;    // of isolines; empty: round ones
    bool has_parts = false;        // E by light
    bool json = false;
};

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

std::optional<std::vector<double>> numbers_in(const std::string& text) {
    std::vector<double> numbers;
    for (const std::string& part : split(text, ',')) {
        const auto number = settings::parse_number(part);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

/// "X,Y,Z;UX,UY,UZ;VX,VY,VZ"; absent if it is not three triples.
std::optional<StatedPlane> parse_plane(const std::string& text) {
    std::vector<glm::dvec3> triples;
    for (const std::string& part : split(text, ';')) {
        const auto numbers = numbers_in(part);
        if (!numbers || numbers->size() != 3) return std::nullopt;
        triples.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
    }
    if (triples.size() != 3) return std::nullopt;
    return StatedPlane{triples[0], vec3(triples[1]), vec3(triples[2])};
}

StatedPlane plane_named(const std::string& text) {
    const auto plane = parse_plane(text);
    if (!plane)
        throw CLI::ValidationError(
            "--plane",
            fmt::format("'{}' is not a corner and two edges, such as \"0,0.8,0;4,0,0;0,0,-3\"", text));
    const float area = glm::length(glm::cross(plane->u, plane->v));
    const float lengths = glm::length(plane->u) * glm::length(plane->v);
    if (!(lengths > 0.0f) || !(area > (1.0f - 1e-6f) * lengths))
        throw CLI::ValidationError(
            "--plane",
            fmt::format("the edges of '{}' are not perpendicular: choose edges of a rectangle", text));
    return *plane;
}

scene::Receiver receiver_of(const IlluminanceCommand& command, const scene::Scene& scene) {
    if (command.plane)
        return {vec3(command.plane->corner - scene.origin), command.plane->u, command.plane->v};
    const scene::Bounds bounds = scene::bounds_of(scene);
    if (bounds.is_empty())
        throw Error({command.settings.scene}, "nothing is in the scene that a plane could be fitted to",
                    "state one with --plane");
    return scene::horizontal_receiver(bounds, static_cast<float>(command.height));
}

/// Leaves out a border of `width` metres on all sides.
scene::Receiver without_border(scene::Receiver receiver, float width) {
    const vec3 along_u = glm::normalize(receiver.u) * width, along_v = glm::normalize(receiver.v) * width;
    receiver.corner += along_u + along_v;
    receiver.u -= 2.0f * along_u;
    receiver.v -= 2.0f * along_v;
    return receiver;
}

void require_area(const IlluminanceCommand& command, const scene::Receiver& receiver) {
    const float width = glm::length(receiver.u), height = glm::length(receiver.v);
    const float border = 2.0f * static_cast<float>(command.border);
    if (!(std::min(width, height) > border))
        throw Error({command.settings.scene},
                    fmt::format("the plane of {:.4g} × {:.4g} m has no area{}", width, height,
                                border > 0.0f ? " within its border" : ""),
                    "state another with --plane, or a smaller --border");
}

Size cells_of(const IlluminanceCommand& command, const scene::Receiver& receiver) {
    if (command.grid) return *command.grid;
    const double width = glm::length(receiver.u), height = glm::length(receiver.v);
    const double spacing = command.spacing.value_or(std::max(width, height) / longest_side);
    const auto count = [&](double length) {
        const double cells = std::max(1.0, std::ceil(length / spacing - 1e-6));
        if (cells > max_cells)
            throw CLI::ValidationError("--spacing",
                                       fmt::format("{:.4g} m makes {:.0f} cells of {:.4g} m: choose "
                                                   "{:.2g} m or more",
                                                   spacing, cells, length, length / max_cells));
        return static_cast<int>(cells);
    };
    return {count(width), count(height)};
}

/// Renders E on the receiver by the lights [first, end). @return absent if it was stopped
std::optional<IlluminanceGrid> measure(render::Renderer& renderer, const scene::Receiver& receiver, int first,
                                       int end, int samples, const Interruption& interruption,
                                       const std::string& what) {
    Progress progress(what);
    renderer.clear();
    renderer.use_lights(first, end);
    while (renderer.sample_count() < samples) {
        if (interruption.has_come()) return std::nullopt;
        renderer.add_sample();
        glFinish();
        progress.update(static_cast<double>(renderer.sample_count()) / samples,
                        fmt::format("{}/{}", renderer.sample_count(), samples));
    }
    return output::illuminance_of(renderer.read_film(), receiver);
}

struct Measurement {
    IlluminanceGrid whole;
    std::vector<output::NamedGrid> parts; // by light
};

std::optional<Measurement> measure_all(const IlluminanceCommand& command, picture::OpenScene& open,
                                       const scene::Receiver& receiver, const Interruption& interruption) {
    const scene::Camera camera = scene::add_receiver(open.stage.scene, receiver);
    const render::GpuScene scene = picture::upload(open, command.settings);
    render::RenderOptions options = picture::render_options(command.settings, cells_of(command, receiver));
    options.shader = "views/irradiance.frag";
    render::Renderer renderer(scene, camera, options);
    const std::string unit(scene::name_of({scene::Quantity::irradiance, open.stage.scene.units}));
    const auto grid_of = [&](int first, int end, const std::string& what) {
        auto grid = measure(renderer, receiver, first, end, options.samples, interruption, what);
        if (grid) grid->origin = open.stage.scene.origin;
        if (grid) grid->unit = unit;
        return grid;
    };
    auto whole = grid_of(0, scene.light_count(), "measuring");
    if (!whole) return std::nullopt;
    Measurement measurement{std::move(*whole), {}};
    for (int k = 0; command.has_parts && k < scene.light_count(); ++k) {
        const std::string& name = scene::name_of(open.stage.lights[static_cast<std::size_t>(k)]);
        auto part = grid_of(k, k + 1, name);
        if (!part) return std::nullopt;
        measurement.parts.push_back({name.empty() ? fmt::format("light {}", k) : name, std::move(*part)});
    }
    open.context->require_silence();
    return measurement;
}

/// Lamps with a place, seen along the receiver's normal.
std::vector<output::PlanMark> marks_of(const picture::OpenScene& open, const scene::Receiver& receiver) {
    std::vector<output::PlanMark> marks;
    for (const scene::Light& light : open.stage.lights) {
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

void write_outputs(const IlluminanceCommand& command, const picture::OpenScene& open,
                   const Measurement& measured) {
    image::WholeFiles files;
    const auto add = [&](const std::string& file, const std::string& text) {
        files.add(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    const output::IlluminanceSummary summary = output::summary_of(measured.whole);
    for (const std::string& file : command.outputs) {
        if (file.ends_with(".csv")) {
            add(file, output::csv_of(measured.whole, measured.parts));
            continue;
        }
        const std::vector<double> levels = command.levels.empty()
                                               ? output::round_levels(summary.min, summary.max, isoline_count)
                                               : command.levels;
        add(file, output::plan_svg(measured.whole, levels, marks_of(open, measured.whole.receiver),
                                   std::filesystem::path(command.settings.scene).filename().string()));
    }
    files.put_in_place();
}

ordered_json triple(glm::dvec3 v) { return {v.x, v.y, v.z}; }

ordered_json as_json(const IlluminanceCommand& command, const Measurement& measured) {
    const IlluminanceGrid& grid = measured.whole;
    const output::IlluminanceSummary summary = output::summary_of(grid);
    ordered_json parts = ordered_json::array();
    for (const output::NamedGrid& part : measured.parts)
        parts.push_back({{"light", part.name}, {"mean", output::summary_of(part.grid).mean}});
    return {{"scene", command.settings.scene},
            {"corner [m]", triple(grid.origin + glm::dvec3(grid.receiver.corner))},
            {"u [m]", triple(glm::dvec3(grid.receiver.u))},
            {"v [m]", triple(glm::dvec3(grid.receiver.v))},
            {"normal", triple(glm::dvec3(grid.receiver.normal()))},
            {"columns", grid.columns},
            {"rows", grid.rows},
            {"samples", command.settings.stop.samples},
            {"unit", grid.unit},
            {"mean", summary.mean},
            {"min", summary.min},
            {"min_at [m]", triple(grid.center(summary.min_place.column, summary.min_place.row))},
            {"max", summary.max},
            {"max_at [m]", triple(grid.center(summary.max_place.column, summary.max_place.row))},
            {"min_over_mean", summary.min_over_mean()},
            {"min_over_max", summary.min_over_max()},
            {"dark_cells", summary.dark_cells},
            {"lights", parts}};
}

void print(const IlluminanceCommand& command, const Measurement& measured) {
    const IlluminanceGrid& grid = measured.whole;
    const output::IlluminanceSummary summary = output::summary_of(grid);
    const double width = glm::length(grid.receiver.u), height = glm::length(grid.receiver.v);
    const vec3 n = grid.receiver.normal() + 0.0f; // no -0
    print_data(
        "plane of {:.4g} × {:.4g} m facing {:.3g},{:.3g},{:.3g}: {} × {} cells of {:.3g} × {:.3g} m, {} "
        "samples\n\n",
        width, height, n.x, n.y, n.z, grid.columns, grid.rows, width / grid.columns, height / grid.rows,
        command.settings.stop.samples);
    const auto line = [](const char* name, double value, const std::string& unit, const std::string& more) {
        print_data("  {:<10}{:>11.5g} {:<6}{}\n", name, value, unit, more);
    };
    const auto where = [&](output::GridPlace place) {
        const glm::dvec3 x = grid.center(place.column, place.row);
        return fmt::format("at {:.4g},{:.4g},{:.4g}", x.x, x.y, x.z);
    };
    line("mean", summary.mean, grid.unit, "");
    line("min", summary.min, grid.unit, where(summary.min_place));
    line("max", summary.max, grid.unit, where(summary.max_place));
    line("min/mean", summary.min_over_mean(), "", "uniformity U_o (EN 12464-1)");
    line("min/max", summary.min_over_max(), "", "");
    if (!measured.parts.empty()) print_data("\n  mean by light\n");
    for (const output::NamedGrid& part : measured.parts)
        print_data("  {:>11.5g} {:<6}{}\n", output::summary_of(part.grid).mean, grid.unit, shown(part.name));
    if (summary.dark_cells > 0)
        print_remark("no light reaches {} of {} cells: they are in full shadow, or inside of something",
                     summary.dark_cells, grid.columns * grid.rows);
}

ExitStatus illuminance(const IlluminanceCommand& command) {
    for (const std::string& file : command.outputs) image::require_writable(file);
    picture::PhaseTimes times;
    picture::OpenScene open = picture::open_scene(command.settings, times);
    if (open.stage.lights.empty())
        throw Error({command.settings.scene}, "nothing in the scene emits light",
                    "add lights to the file, or light from outside with --environment");
    scene::Receiver receiver = receiver_of(command, open.stage.scene);
    require_area(command, receiver);
    if (command.border > 0.0) receiver = without_border(receiver, static_cast<float>(command.border));
    const Interruption interruption;
    const auto measured = measure_all(command, open, receiver, interruption);
    if (!measured) {
        print_remark("interrupted: nothing was written");
        return interrupted;
    }
    write_outputs(command, open, *measured);
    if (command.json)
        write_json(as_json(command, *measured).dump(2, ' ', false, ordered_json::error_handler_t::replace));
    else
        print(command, *measured);
    return done;
}

std::string refusal_of_output(const std::string& file) {
    const bool is_known = file.ends_with(".svg") || file.ends_with(".csv");
    return is_known ? "" : fmt::format("'{}' is neither .svg, a plan, nor .csv, numbers", file);
}

std::string refusal_of_spacing(const std::string& text) {
    const auto number = settings::parse_number(text);
    return number && *number > 0.0 ? "" : fmt::format("'{}' is not a length above 0 [m]", text);
}

std::string refusal_of_border(const std::string& text) {
    const auto number = settings::parse_number(text);
    return number && *number >= 0.0 ? "" : fmt::format("'{}' is not a length of 0 or more [m]", text);
}

/// The plane, its cells and the outputs.
void declare_own_options(CLI::App& command, const std::shared_ptr<IlluminanceCommand>& options) {
    command
        .add_option("-o,--output", options->outputs,
                    "OUT.svg for a plan with isolines, OUT.csv for the numbers (repeatable)")
        ->type_name("OUT")
        ->check(refusal_of_output)
        ->allow_extra_args(false);
    command.add_flag("--json", options->json, "print JSON");
    command
        .add_option_function<std::string>(
            "--plane", [options](const std::string& text) { options->plane = plane_named(text); },
            "the plane's corner and two perpendicular edges [m]; light counts on the side that U × V points "
            "to "
            "(default: horizontal, as wide and deep as the scene, lit from above)")
        ->type_name("X,Y,Z;UX,UY,UZ;VX,VY,VZ");
    command
        .add_option("--height", options->height, "height of the default plane above the scene's lowest point")
        ->type_name("METRES")
        ->check(refusal_of_number)
        ->capture_default_str();
    command.add_option("--border", options->border, "leave out a strip of this width along all edges")
        ->type_name("METRES")
        ->check(refusal_of_border)
        ->capture_default_str();
    CLI::Option* grid = command.add_option_function<std::string>(
        "--grid",
        [options](const std::string& text) {
            options->grid = settings::parse_size(text);
            if (!options->grid || std::max(options->grid->width, options->grid->height) > max_cells)
                throw CLI::ValidationError(
                    "--grid",
                    fmt::format("'{}' is not COLUMNSxROWS, such as 32x24, up to {}", text, max_cells));
        },
        "cells along U and V (default: 64 along the longer edge)");
    grid->type_name("COLUMNSxROWS");
    command.add_option("--spacing", options->spacing, "greatest side of a cell instead")
        ->type_name("METRES")
        ->check(refusal_of_spacing)
        ->excludes(grid);
    command
        .add_option_function<std::string>(
            "--isolines",
            [options](const std::string& text) {
                const auto levels = numbers_in(text);
                if (!levels || levels->empty())
                    throw CLI::ValidationError("--isolines",
                                               fmt::format("'{}' is not E,E,..., such as 200,300,500", text));
                options->levels = *levels;
            },
            "levels of the plan's isolines (default: round ones)")
        ->type_name("E,E...");
    command.add_flag("--by-light", options->has_parts,
                     "the mean of each light as well, and its column in .csv; takes about twice as long");
}

} // namespace

void add_illuminance_command(CLI::App& app) {
    const auto options = std::make_shared<IlluminanceCommand>();
    options->settings.rig = scene::Rig::none; // a room is lit by its own lamps
    options->settings.stop.samples = 64;      // a cell is one pixel, so they cost little
    CLI::App* command = app.add_subcommand(
        "illuminance", "measure the light that falls on a plane: mean, extremes, isolines");
    command->add_option("SCENE", options->settings.scene, "a .gltf or .glb file")->required();
    declare_own_options(*command, options);
    declare(*command, settings::by_illuminance, options->settings);
    command->get_option("--rig")->default_str("none");
    command->get_option("--samples")->default_str(std::to_string(options->settings.stop.samples));
    command->footer(
        "E is direct light: shadows count, light that walls reflect does not. The plane itself casts no "
        "shadow on\n"
        "its front. Each cell is the mean over its area. Cells within furniture are dark, and count: with\n"
        "--visibility none the plane is that of an empty room.\n\n"
        "Examples:\n"
        "  steradian illuminance $(steradian samples office)\n"
        "  steradian illuminance office.gltf --height 0.76 --border 0.5 -o plan.svg -o cells.csv\n"
        "  steradian illuminance office.gltf --plane \"-2,0.76,-1;1,0,0;0,0,-1\" --spacing 0.1 --by-light\n"
        "  steradian illuminance office.gltf --isolines 200,300,500 -o plan.svg --json | jq .min_over_mean");
    command->callback([options] {
        const ExitStatus status = illuminance(*options);
        if (status != done) throw CLI::RuntimeError(status);
    });
}

} // namespace sr::cli
