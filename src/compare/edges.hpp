#pragma once
// Failing pixels that are forgiven, because an edge fell to the other side of the pixel's centre.
#include "compare/align.hpp"

#include <functional>
#include <vector>

namespace sr::compare {

// Caps on the pixels that edges explain. None of them grows with the image: damage does not become harmless
// because more pixels surround it. Two drivers differ in a handful of pixels that lie apart from one another.
inline constexpr std::size_t max_at_edges = 48;    // pixels of the image
inline constexpr double max_share_at_edges = 1e-3; // of the pixels of a small image
inline constexpr int edge_window = 64;             // [pixels] edge
inline constexpr int max_at_edges_nearby = 16;     // in any such window
inline constexpr std::size_t max_edge_cluster = 4; // pixels that touch one another

// A row or a column with failing pixels is wrong as a whole if the third quartile of its pixels' differences
// is as many times that of the lines beside it.
inline constexpr std::size_t min_in_wrong_line = 2;
inline constexpr float wrong_line_ratio = 8.0f;

inline constexpr int surface_window = 7;      // [pixels] edge, around the pixel
inline constexpr std::size_t min_surface = 6; // pixels of one side in that window that hang together

inline constexpr float max_grain = 3.0f;        // a change in it, over the median distance of adjacent pixels
inline constexpr float max_grain_limits = 6.0f; // the same, over the limit

inline constexpr float max_slope_share = 1.0f / 64; // a change on a slope, over the range of the 3×3 pixels
inline constexpr float max_slope_limits = 2.0f;     // the same, over the limit

/// The largest distance of the new value from those around it, as a share of the change of the channel that
/// changed most: a sample at a ball's limb sees a shade that no pixel beside it has.
inline constexpr float max_overshoot = 1.0f / 12;

/// The largest distance of the old value from those around it, as a share of the change.
inline constexpr float max_lost_share = 0.5f;

/// The difference from a value of a pixel's channel that a limit allows.
using Slack = std::function<float(std::size_t pixel, std::size_t channel, float value)>;

/// The failing pixels, and how many of them an edge explains.
struct EdgeJudgement {
    std::size_t failing = 0;
    std::size_t unexplained = 0;  // fail the image
    std::size_t max_count = 0;    // the cap on all failing pixels
    bool is_crowded = false;      // more than max_at_edges_nearby in a window
    bool is_in_line = false;      // at even distances in a row or a column
    bool is_in_rectangle = false; // most at the corners of rectangles
    bool is_line_wrong = false;   // the other pixels of a row or a column changed too
    bool passes() const {
        return unexplained == 0 && failing <= max_count && !is_crowded && !is_in_line && !is_in_rectangle
               && !is_line_wrong;
    }
};

/// Judges the failing pixels. An edge explains a pixel if all of this is so:
///
/// 1. Nothing new appeared, such as a hole or a firefly: its value lies within the range of the reference's
///    3×3 pixels around it, in each channel.
///
/// 2. Nothing disappeared, such as a wire or a small object: the reference's value lies within the range of
///    the test's 3×3 pixels, or near it in a picture with grain.
///
/// 3. Both sides of the edge are there, in the reference and in the test: on the circle of its 8 neighbours,
///    those that resemble the old value are one arc of at least two, and those that resemble the new one are
///    another; of three where failing pixels touch. A gap in a line has two arcs of the line's colour.
///
/// 4. What lost the pixel is a surface and no speck: around it, at least min_surface pixels hang together.
///
/// 5. It touches at most three other failing pixels, directly or through one another.
///
/// In grain, where adjacent pixels differ as much as the pixel changed, and that is little, there is no edge
/// to find: 2, 3 and 4 need not be so. On a slope, where a picture moved by a 64th of a pixel changes as
/// much, and that is less than twice the limit, only 5 needs to be so.
///
/// @param fails one entry for each compared pixel
EdgeJudgement judge_edges(const AlignedImages& images, const std::vector<bool>& fails, const Slack& slack);

} // namespace sr::compare
