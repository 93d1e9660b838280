#pragma once
// Illuminance on a horizontal measuring plane, as lighting designers tabulate it.
#include "image/image.hpp"
#include "render/renderer.hpp"
#include "scene/prepare.hpp"

#include <string>
#include <vector>

namespace sr::output {

/// A horizontal rectangle that light falls on from above. It blocks no light and belongs to no surface.
struct MeasuringPlane {
    double height = 0.0;  // y in the file's world [m]
    glm::dvec2 from{0.0}; // x and z of one corner in the file's world [m]
    glm::dvec2 to{1.0};   // of the opposite corner, greater in both
    int columns = 1;      // of cells, along x
    int rows = 1;         // along z

    /// x and z of the centre of a cell in the file's world [m].
    glm::dvec2 center_of(int column, int row) const;
};

/// E of each cell of a plane, as luminances [lx, W/m² in radiometric scenes].
struct IlluminanceTable {
    MeasuringPlane plane;
    std::vector<float> values; // row by row; z and x ascend

    float at(int column, int row) const {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(plane.columns)
                      + static_cast<std::size_t>(column)];
    }
    double min() const;
    double mean() const;
    double max() const;
    /// min / mean, U_o of EN 12464-1:2021; 0 without light.
    double uniformity() const;
};

/// Evaluates E = Σ ∫ L_i V cosθ_i dω_i on a plane in the scene, as the view `irradiance` does. A single
/// sample is at the centre of each cell; more samples are the mean over the cell. `options`: samples, seed
/// and shaders; size and fragment shader do not matter. Needs a current context. @throws Error
IlluminanceTable illuminance_on(const MeasuringPlane& plane, scene::RenderScene stage,
                                render::Visibility visibility, render::RenderOptions options);

/// The table as text: a head, then a line for each cell with x, y, z [m] of its centre and E.
std::string csv_of(const IlluminanceTable& table, scene::UnitSystem units);

/// Round values for isolines between the least and the greatest value, ascending, at most ten.
std::vector<double> isoline_levels(const IlluminanceTable& table);

/// A picture of the table, its longer side `pixels` long: the colour map from 0 to the greatest value, with
/// black isolines. X points right, Z down.
image::Image isoline_picture(const IlluminanceTable& table, int pixels);

} // namespace sr::output
