#pragma once
// Rare events among samples: a few seeds see some of them, and not all.
#include "image/image.hpp"

namespace sr::compare {

/// The number of events that Poisson's law exceeds with at most the given chance.
std::size_t most_events(double expected, double chance);

/// Counts the rare events that the pictures of a noise image had: pixels of which a single sample makes the
/// standard error so large that its picture would exceed the limit beside another. The errors around it,
/// but for the largest, are smaller: those of an edge are not.
/// @param limit of a difference [standard errors without the event]
std::size_t seen_events(const image::Image& errors, double seeds, double limit);

} // namespace sr::compare
