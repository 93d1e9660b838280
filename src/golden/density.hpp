#pragma once
// How much failing pixels cluster.
#include "golden/pair.hpp"

namespace sr::golden {

inline constexpr int density_window = 16; // [pixels] edge

/// The largest share of failing pixels in any window of 16×16 pixels (or of the image, along an edge that is
/// shorter). `fails` has one entry for each compared pixel; all others count as passing.
double densest_window(const Pair& pair, const std::vector<bool>& fails);

} // namespace sr::golden
