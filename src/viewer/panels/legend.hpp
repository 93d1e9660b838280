#pragma once
// Legend of a view: its meaning and unit, and the values of its colours.
#include "viewer/app/layout.hpp"
#include "viewer/view/presenter.hpp"

#include <string>

namespace sr::viewer {

/// Draws the legend over the lower left of the picture. `scale`: of a HiDPI screen.
void draw_legend(const Area& picture, const output::Variable& view, const DisplaySettings& display,
                 const std::string& unit, float scale);

/// The range of false colours that a film has: from the least to the greatest luminance, without a hundredth
/// of the lit pixels at each end, in tenths of a decade. Absent for a film without lit pixels.
std::optional<image::Decades> range_of(const image::Image& film);

} // namespace sr::viewer
