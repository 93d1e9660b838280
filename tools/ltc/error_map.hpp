#pragma once
// The analytic estimator's error as a picture.
#include <filesystem>

namespace sr::ltc {

/// Median error of random polygons over metal: roughness from 0.05 (top) to 1, the angle between n and wo from 0 (left)
/// to 88°; the left half without points, the right half with 16. Colours: write_error_map()'s steps, below as a legend.
/// @throws Error if the file cannot be written.
void write_error_map(const std::filesystem::path& file);

} // namespace sr::ltc
