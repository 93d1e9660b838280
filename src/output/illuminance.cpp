#include "output/illuminance.hpp"

#include "core/error.hpp"
#include "core/markup.hpp"

#include <cmath>
#include <fmt/format.h>

namespace sr::output {

double IlluminanceGrid::at(int column, int row) const {
    return luminance(glm::dvec3(E[static_cast<std::size_t>(row) * columns + column]));
}

glm::dvec3 IlluminanceGrid::center(int column, int row) const {
    const double s = (column + 0.5) / columns, t = (rows - 0.5 - row) / rows;
    return origin + glm::dvec3(receiver.corner) + s * glm::dvec3(receiver.u) + t * glm::dvec3(receiver.v);
}

IlluminanceGrid illuminance_of(const image::Image& film, const scene::Receiver& receiver) {
    IlluminanceGrid grid{receiver, {}, film.width, film.height, {}, {}};
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const auto pixel = film.at(x, y);
            const vec3 E(pixel[0], pixel[1], pixel[2]);
            if (!std::isfinite(E.x + E.y + E.z))
                throw Error(fmt::format("the illuminance of cell {},{} is not finite", x, y),
                            "look at the scene's lights with steradian info");
            grid.E.push_back(E);
        }
    return grid;
}

IlluminanceSummary summary_of(const IlluminanceGrid& grid) {
    IlluminanceSummary summary;
    summary.min = summary.max = grid.at(0, 0);
    double sum = 0.0;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const double E = grid.at(column, row);
            sum += E;
            summary.dark_cells += E <= 0.0;
            if (E < summary.min) {
                summary.min = E;
                summary.min_place = {column, row};
            }
            if (E > summary.max) {
                summary.max = E;
                summary.max_place = {column, row};
            }
        }
    summary.mean = sum / (static_cast<double>(grid.columns) * grid.rows);
    return summary;
}

std::string_view reason_of_dark_cells(const IlluminanceGrid& grid, const IlluminanceSummary& summary) {
    const bool are_all = summary.dark_cells == static_cast<std::size_t>(grid.columns) * grid.rows;
    if (!are_all) return "they are in full shadow, or inside of something";
    return "the plane faces away from the lights, lies above them or outside of the scene, or is in full "
           "shadow: choose another height or plane";
}

std::string csv_of(const IlluminanceGrid& grid, const std::vector<NamedGrid>& parts) {
    std::string csv = fmt::format("x [m],y [m],z [m],E [{}]", grid.unit);
    for (const NamedGrid& part : parts) csv += "," + csv_cell(fmt::format("{} [{}]", part.name, grid.unit));
    csv += "\r\n";
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const glm::dvec3 x = grid.center(column, row);
            csv += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g}", x.x, x.y, x.z, grid.at(column, row));
            for (const NamedGrid& part : parts) csv += fmt::format(",{:.6g}", part.grid.at(column, row));
            csv += "\r\n";
        }
    return csv;
}

} // namespace sr::output
