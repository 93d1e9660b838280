// The analytic estimator's error: every cell of roughness and view, every shape, as a table in Markdown.
#include "error_map.hpp"
#include "ltc/trial.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fmt/format.h>
#include <numbers>

namespace {

using namespace sr::ltc;

struct Arguments {
    int trials = 150;
    int rays = 1 << 16;
    std::string shape = "all";
    std::vector<int> points{0, 8, 16, 32};
    std::string map;
};

constexpr double degree = std::numbers::pi / 180.0;

std::string median_and_95(const std::vector<double>& errors) {
    return fmt::format("{:.2f} / {:.2f}", 100.0 * errors[errors.size() / 2],
                       100.0 * errors[errors.size() * 95 / 100]);
}

void print_table(const Arguments& arguments, const char* name, Shape shape, Material material) {
    fmt::print(
        "\n**{}.** Relative error [%], median / 95th percentile of {} emitters.\n\n| roughness | view |",
        name, arguments.trials);
    for (const int points : arguments.points) fmt::print(" {} points |", points);
    fmt::print("\n|---|---|{}\n", [&] {
        std::string rule;
        for (std::size_t i = 0; i < arguments.points.size(); ++i) rule += "---|";
        return rule;
    }());
    for (const double roughness : {0.1, 0.3, 0.5, 0.7, 1.0})
        for (const auto& [least, greatest] : {std::pair(0.0, 30.0), {60.0, 60.0}, {75.0, 85.0}}) {
            const auto cell = trials(shape, material, {roughness, least * degree, greatest * degree},
                                     arguments.trials, 1, arguments.rays);
            fmt::print("| {} | {} |", roughness,
                       least == greatest ? fmt::format("{}°", least)
                                         : fmt::format("{}–{}°", least, greatest));
            for (const int points : arguments.points)
                fmt::print(" {} |", median_and_95(errors(cell, evaluated(cell, material, points))));
            fmt::print("\n");
            std::fflush(stdout);
        }
}

} // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CLI::App app{"The analytic estimator's error against brute force, as a table."};
    app.add_option("--trials", arguments.trials, "emitters a cell")->capture_default_str();
    app.add_option("--rays", arguments.rays, "directions of the brute force")->capture_default_str();
    app.add_option("--shape", arguments.shape, "polygon|disk|sphere|tube|plastic|all")->capture_default_str();
    app.add_option("--points", arguments.points, "points a lobe")->delimiter(',')->capture_default_str();
    app.add_option("--map", arguments.map,
                   "a .png instead of the tables: the median error, without points and with 16");
    CLI11_PARSE(app, argc, argv);
    if (!arguments.map.empty()) {
        sr::ltc::write_error_map(arguments.map);
        return 0;
    }
    const auto wanted = [&](const char* name) { return arguments.shape == "all" || arguments.shape == name; };
    if (wanted("polygon")) print_table(arguments, "Polygons over metal", Shape::polygon, Material::metal);
    if (wanted("plastic")) print_table(arguments, "Polygons over plastic", Shape::polygon, Material::plastic);
    if (wanted("disk")) print_table(arguments, "Disks and ellipses over metal", Shape::disk, Material::metal);
    if (wanted("sphere")) print_table(arguments, "Spheres over metal", Shape::sphere, Material::metal);
    if (wanted("tube")) print_table(arguments, "Tubes over metal", Shape::tube, Material::metal);
    return 0;
}
