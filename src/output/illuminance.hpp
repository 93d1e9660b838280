#pragma once
// Illuminance over the cells of a receiver, and its mean, extremes and uniformity.
#include "image/image.hpp"
#include "scene/receiver.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace sr::output {

/// The illuminance of each cell of a receiver.
struct IlluminanceGrid {
    scene::Receiver receiver;
    glm::dvec3 origin{0.0}; // of the scene's coordinates in the file's world [m]
    int columns = 0;
    int rows = 0;
    std::vector<vec3> E; // mean of each cell [lx or W/m²], RGB; rows along -v, as a picture has them
    std::string unit;    // "lx" or "W/m^2"

    /// E of a cell as one number: the luminance of its RGB.
    double at(int column, int row) const;
    /// The centre of a cell in the file's world [m].
    glm::dvec3 center(int column, int row) const;
};

/// Takes E from a film of views/irradiance.frag of the whole receiver. @throws Error if a cell is not finite
IlluminanceGrid illuminance_of(const image::Image& film, const scene::Receiver& receiver);

struct GridPlace {
    int column = 0;
    int row = 0;
};

/// The figures of EN 12464-1:2021, section 3: the mean of the cells, their extremes, and the uniformity.
struct IlluminanceSummary {
    double mean = 0.0;
    double min = 0.0;
    double max = 0.0;
    GridPlace min_place;
    GridPlace max_place;
    std::size_t dark_cells = 0; // no light at all arrives: inside of things, or in a full shadow

    /// U_o, 0 to 1; 0 where nothing arrives.
    double min_over_mean() const { return mean > 0.0 ? min / mean : 0.0; }
    double min_over_max() const { return max > 0.0 ? min / max : 0.0; }
};

/// `grid` has one cell at least.
IlluminanceSummary summary_of(const IlluminanceGrid& grid);

/// Words for why no light reaches the dark cells: some of the plane, or the plane as a whole.
std::string_view reason_of_dark_cells(const IlluminanceGrid& grid, const IlluminanceSummary& summary);

/// A line a cell: "x [m],y [m],z [m],E [lx]" and, for each further grid of the same receiver, its E under its
/// name. RFC 4180.
struct NamedGrid {
    std::string name;
    IlluminanceGrid grid;
};
std::string csv_of(const IlluminanceGrid& grid, const std::vector<NamedGrid>& parts);

} // namespace sr::output
