#include "cli/commands.hpp"
#include "cli/open_scene.hpp"
#include "core/error.hpp"
#include "core/output.hpp"
#include "image/whole_file.hpp"
#include "output/illuminance.hpp"
#include "output/variables.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace sr::cli {
namespace {

struct IlluminanceCommand {
    RenderSettings rendering;
    double height = 0.0;                         // [m]
    std::optional<std::array<double, 4>> region; // x, z of two corners [m]; absent: the scene's
    std::optional<double> spacing;               // of cells [m]; absent: a fiftieth of the longer side
    std::vector<std::string> files;
    bool json = false;
};

/// "X0,Z0,X1,Z1"; absent if it is not four numbers, the first two smaller.
std::optional<std::array<double, 4>> parse_region(std::string text) {
    std::ranges::replace(text, ',', ' ');
    std::istringstream in(text);
    std::array<double, 4> region{};
    for (double& number : region)
        if (!(in >> number) || !std::isfinite(number)) return std::nullopt;
    std::string rest;
    if (in >> rest || region[0] >= region[2] || region[1] >= region[3]) return std::nullopt;
    return region;
}

output::MeasuringPlane plane_of(const IlluminanceCommand& command, const scene::Scene& scene) {
    output::MeasuringPlane plane;
    plane.height = command.height;
    if (command.region) {
        const auto& [x0, z0, x1, z1] = *command.region;
        plane.from = {x0, z0};
        plane.to = {x1, z1};
    } else {
        const scene::Bounds bounds = scene::bounds_of(scene);
        const bool is_flat =
            bounds.is_empty() || bounds.min.x == bounds.max.x || bounds.min.z == bounds.max.z;
        if (is_flat)
            throw Error({command.rendering.scene}, "covers no ground", "state the plane with --region");
        plane.from = glm::dvec2(scene.origin.x + bounds.min.x, scene.origin.z + bounds.min.z);
        plane.to = glm::dvec2(scene.origin.x + bounds.max.x, scene.origin.z + bounds.max.z);
    }
    const glm::dvec2 size = plane.to - plane.from;
    constexpr double cells = 50.0, most = 4096.0;
    const double spacing = command.spacing.value_or(std::max(size.x, size.y) / cells);
    const glm::dvec2 counts = glm::max(glm::round(size / spacing), glm::dvec2(1.0));
    if (std::max(counts.x, counts.y) > most)
        throw CLI::ValidationError("--spacing",
                                   fmt::format("{} m makes {:.0f} by {:.0f} cells: at most {:.0f}", spacing,
                                               counts.x, counts.y, most));
    plane.columns = static_cast<int>(counts.x);
    plane.rows = static_cast<int>(counts.y);
    return plane;
}

/// Writes a table for .csv, a picture for any other extension; all files or none.
void write(const output::IlluminanceTable& table, const IlluminanceCommand& command,
           scene::UnitSystem units) {
    constexpr int pixels = 1024;
    image::WholeFiles files;
    for (const std::string& file : command.files) {
        if (std::filesystem::path(file).extension() == ".csv") {
            const std::string text = output::csv_of(table, units);
            files.add(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        } else {
            files.add(output::isoline_picture(table, pixels), file, image::SampleType::integer8);
        }
    }
    files.put_in_place();
}

void print(const output::IlluminanceTable& table, const std::string& unit) {
    const output::MeasuringPlane& plane = table.plane;
    print_data("plane at y = {:g} m, x {:g} to {:g} m, z {:g} to {:g} m, {} by {} cells\n\n", plane.height,
               plane.from.x, plane.to.x, plane.from.y, plane.to.y, plane.columns, plane.rows);
    print_data("  E min         {:.5g} {}\n", table.min(), unit);
    print_data("  E mean        {:.5g} {}\n", table.mean(), unit);
    print_data("  E max         {:.5g} {}\n", table.max(), unit);
    print_data("  uniformity    {:.3f} (min / mean)\n", table.uniformity());
    print_data("  isolines      {:g} {}\n", fmt::join(output::isoline_levels(table), ", "), unit);
}

void print_json(const output::IlluminanceTable& table, const std::string& unit) {
    const output::MeasuringPlane& plane = table.plane;
    const auto with_unit = [&](const char* name) { return fmt::format("{} [{}]", name, unit); };
    write_json(nlohmann::ordered_json{{"y [m]", plane.height},
                                      {"x [m]", {plane.from.x, plane.to.x}},
                                      {"z [m]", {plane.from.y, plane.to.y}},
                                      {"columns", plane.columns},
                                      {"rows", plane.rows},
                                      {with_unit("E_min"), table.min()},
                                      {with_unit("E_mean"), table.mean()},
                                      {with_unit("E_max"), table.max()},
                                      {"uniformity", table.uniformity()},
                                      {with_unit("isolines"), output::isoline_levels(table)}}
                   .dump(2));
}

void measure(const IlluminanceCommand& command) {
    PhaseTimes times;
    const OpenScene open = open_scene(command.rendering, times);
    const scene::UnitSystem units = open.stage.scene.units;
    const output::MeasuringPlane plane = plane_of(command, open.stage.scene);
    const output::IlluminanceTable table = output::illuminance_on(
        plane, open.stage, command.rendering.visibility, render_options(command.rendering, open.size));
    open.context->require_silence();
    write(table, command, units);
    const std::string unit = output::unit_of(output::view_named("irradiance"), units);
    if (command.json)
        print_json(table, unit);
    else
        print(table, unit);
}

} // namespace

void add_illuminance_command(CLI::App& app) {
    const auto options = std::make_shared<IlluminanceCommand>();
    CLI::App* command = app.add_subcommand(
        "illuminance", "tabulate illuminance on a horizontal plane: min, mean, max, isolines");
    command->add_option("SCENE", options->rendering.scene, "a .gltf or .glb file")->required();
    declare(*command, settings::by_probe, options->rendering);
    command->add_option("--plane", options->height, "height of the plane: y in the world [m]")
        ->type_name("Y")
        ->required();
    command
        ->add_option_function<std::string>(
            "--region",
            [options](const std::string& text) {
                options->region = parse_region(text);
                if (!options->region)
                    throw CLI::ValidationError(
                        "--region",
                        "'" + text + "' is not X0,Z0,X1,Z1 with X0 < X1 and Z0 < Z1, such as 0,0,6,4");
            },
            "two corners of the plane [m]; without it the extent of the scene")
        ->type_name("X0,Z0,X1,Z1");
    command
        ->add_option("--spacing", options->spacing,
                     "side of a cell [m]; without it a fiftieth of the longer side")
        ->check(CLI::PositiveNumber)
        ->type_name("METRES");
    command->add_option("-o,--output", options->files,
                        "write the table (.csv) or a picture with isolines (.png, .jpg); repeatable");
    command->add_flag("--json", options->json, "print JSON");
    command->footer(
        "The plane looks up, blocks no light and need not be a surface of the scene. A sample is the "
        "value at the\ncentre of a cell; more samples are means over the cell.\n\n"
        "Examples:\n"
        "  steradian illuminance room.glb --plane 0.8\n"
        "  steradian illuminance room.glb --plane 0.8 --region 0,0,6,4 --spacing 0.25 -o desk.csv -o "
        "desk.png");
    command->callback([options] { measure(*options); });
}

} // namespace sr::cli
