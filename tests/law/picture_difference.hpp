#pragma once
// How two pictures of the same scene differ, but for rounding.
#include "image/image.hpp"

#include <string>

namespace sr::testing {

/// Pixels that differ by more than 1 % and a thousandth of the mean.
struct Difference {
    int moved = 0;     // within what the other picture has around them: an edge may have moved
    int strange = 0;   // others
    std::string first; // of the others: its place and values

    /// Returns whether no more differ than rounding moves edges across pixels' centres.
    bool is_small() const { return strange <= 3 && moved <= 40; }
};

Difference difference_of(const image::Image& a, const image::Image& b);

image::Image in_a_mirror(const image::Image& picture);

} // namespace sr::testing
