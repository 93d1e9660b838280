#pragma once
// Places of failing pixels that chance does not choose: rows, rhythms and rectangles.
#include <cstddef>
#include <unordered_set>
#include <vector>

namespace sr::compare {

inline constexpr std::size_t max_in_rhythm = 3;          // in a row or column, if all distances are equal
inline constexpr std::size_t max_in_rhythm_of_more = 4;  // the same, where others lie in the line
inline constexpr std::size_t min_distance_in_rhythm = 4; // [pixels] of those
inline constexpr double min_distance_of_evenness = 6.0;  // [pixels] on average
inline constexpr double max_chance_of_evenness = 1e-3;   // of places that chance chooses

/// The chance that places in a line are as even as these, or more, if each pixel of the line is as likely as
/// any other: the numbers of pixels between them are then near to exponential, and Bartlett's statistic to
/// chi-squared (Moran 1951). It is 1 for fewer than three places, and for places so close that their
/// distances can hardly differ. Places that touch are one.
///
/// @param places sorted, each once
double chance_of_evenness(const std::vector<std::size_t>& places);

/// True if a row or a column has pixels at equal distances, or so even that chance hardly chooses them, as a
/// serrated edge and a dotted line have. Of a straight edge, chance chooses those that fall to the other
/// side.
///
/// @param pixels row by row
/// @param width [pixels]
bool are_in_line(const std::unordered_set<std::size_t>& pixels, std::size_t width);

/// True if most of the pixels are corners of upright rectangles, as where all corners of a button change.
/// Those of a cluster do not count. Among many pixels at two straight edges, chance puts a few at such
/// corners.
bool are_in_rectangle(const std::unordered_set<std::size_t>& pixels, std::size_t width);

} // namespace sr::compare
