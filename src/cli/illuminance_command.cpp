#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/interruption.hpp"
#include "cli/progress.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "core/text.hpp"
#include "image/whole_file.hpp"
#include "picture/illuminance.hpp"
#include "picture/open_scene.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace sr::cli {
namespace {

using nlohmann::ordered_json;
using output::IlluminanceGrid;

struct IlluminanceCommand {
    RenderSettings settings;
    std::vector<std::string> outputs; // .svg or .csv
    picture::ReceiverChoice receiver;
    std::optional<Size> grid;
    std::optional<double> spacing; // [m]
    std::vector<double> levels;    // of isolines; empty: round ones
    bool has_parts = false;        // E by light
    bool json = false;
};

std::optional<std::vector<double>> numbers_in(const std::string& text) {
    std::vector<double> numbers;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) {
        const auto number = settings::parse_number(part);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

picture::StatedPlane plane_named(const std::string& text) {
    try {
        return picture::parse_plane(text);
    } catch (const Error& error) {
        throw CLI::ValidationError("--plane", error.what());
    }
}

Size cells_of(const IlluminanceCommand& command, const scene::Receiver& receiver) {
    if (command.grid) return *command.grid;
    try {
        return picture::cells_of(receiver, command.spacing);
    } catch (const Error& error) {
        throw CLI::ValidationError("--spacing", error.what());
    }
}

/// Renders E on the receiver by the lights [first, end). @return absent if it was stopped
std::optional<IlluminanceGrid> measure(picture::IlluminanceRender& render, int first, int end, int samples,
                                       const Interruption& interruption, const std::string& what) {
    Progress progress(what);
    render.begin(first, end);
    while (render.sample_count() < samples) {
        if (interruption.has_come()) return std::nullopt;
        render.add_sample();
        glFinish();
        progress.update(static_cast<double>(render.sample_count()) / samples,
                        fmt::format("{}/{}", render.sample_count(), samples));
    }
    return render.grid();
}

struct Measurement {
    IlluminanceGrid whole;
    std::vector<output::NamedGrid> parts; // by light
};

std::optional<Measurement> measure_all(const IlluminanceCommand& command, picture::IlluminanceRender& render,
                                       const Interruption& interruption) {
    const int samples = command.settings.stop.samples;
    auto whole = measure(render, 0, render.light_count(), samples, interruption, "measuring");
    if (!whole) return std::nullopt;
    Measurement measurement{std::move(*whole), {}};
    for (int k = 0; command.has_parts && k < render.light_count(); ++k) {
        const std::string name = render.name_of_light(k);
        auto part = measure(render, k, k + 1, samples, interruption, name);
        if (!part) return std::nullopt;
        measurement.parts.push_back({name, std::move(*part)});
    }
    return measurement;
}

void write_outputs(const IlluminanceCommand& command, const std::vector<scene::Light>& lights,
                   const Measurement& measured) {
    image::WholeFiles files;
    const auto add = [&](const std::string& file, const std::string& text) {
        files.add(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    for (const std::string& file : command.outputs)
        add(file, file.ends_with(".csv")
                      ? output::csv_of(measured.whole, measured.parts)
                      : picture::plan_of(measured.whole, command.levels, lights, command.settings.scene));
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
        print_remark("no light reaches {} of {} cells: {}", summary.dark_cells, grid.columns * grid.rows,
                     output::reason_of_dark_cells(grid, summary));
}

ExitStatus illuminance(const IlluminanceCommand& command) {
    for (const std::string& file : command.outputs) image::require_writable(file);
    picture::PhaseTimes times;
    picture::OpenScene open = picture::open_scene(command.settings, times);
    if (open.stage.lights.empty())
        throw Error({command.settings.scene}, "nothing in the scene emits light",
                    "add lights to the file, or light from outside with --environment");
    const scene::Receiver receiver =
        picture::receiver_of(command.receiver, open.stage.scene, command.settings.scene);
    const render::RenderOptions options =
        picture::render_options(command.settings, cells_of(command, receiver));
    picture::IlluminanceRender render(std::move(open.stage), receiver, command.settings, options);
    const Interruption interruption;
    const auto measured = measure_all(command, render, interruption);
    open.context->require_silence();
    if (!measured) {
        print_remark("interrupted: nothing was written");
        return interrupted;
    }
    write_outputs(command, render.lights(), *measured);
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
            "--plane", [options](const std::string& text) { options->receiver.plane = plane_named(text); },
            "the plane's corner and two perpendicular edges [m]; light counts on the side that U × V points "
            "to "
            "(default: horizontal, as wide and deep as the scene, lit from above)")
        ->type_name("X,Y,Z;UX,UY,UZ;VX,VY,VZ");
    command
        .add_option("--height", options->receiver.height,
                    "height of the default plane above the scene's lowest point")
        ->type_name("METRES")
        ->check(refusal_of_number)
        ->capture_default_str();
    command
        .add_option("--border", options->receiver.border, "leave out a strip of this width along all edges")
        ->type_name("METRES")
        ->check(refusal_of_border)
        ->capture_default_str();
    CLI::Option* grid = command.add_option_function<std::string>(
        "--grid",
        [options](const std::string& text) {
            options->grid = settings::parse_size(text);
            if (!options->grid || std::max(options->grid->width, options->grid->height) > picture::max_cells)
                throw CLI::ValidationError("--grid",
                                           fmt::format("'{}' is not COLUMNSxROWS, such as 32x24, up to {}",
                                                       text, picture::max_cells));
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
    options->settings.stop.samples = picture::illuminance_samples;
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
