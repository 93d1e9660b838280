#pragma once
// The mistakes that have a name. Each function tries a family of them on the evidence.
#include "golden/evidence.hpp"

namespace sr::golden {

/// A mistake tried, and how much it leaves.
struct Trial {
    Diagnosis diagnosis;
    int freedom = 0; // of two that explain as much, the one with less freedom to fit is believed
};
using Trials = std::vector<Trial>;

/// The whole test image is black, or of one colour.
void try_blank(const Evidence& evidence, Trials& trials);

/// A factor: π, two, 4π, 683, an exposure, one for each channel; a constant added.
void try_factors(const Evidence& evidence, Trials& trials);

/// sRGB or a plain gamma applied, missing, applied twice; values clamped to 1.
void try_curves(const Evidence& evidence, Trials& trials);

/// Channels in another order.
void try_channel_orders(const Evidence& evidence, Trials& trials);

/// Flipped, turned, transposed; shifted by up to two pixels.
void try_places(const Evidence& evidence, Trials& trials);

/// Turned on its side, where the images' sizes are swapped; relative to an image of one colour, the mean.
void try_turned(const image::Image& test, const image::Image& reference, Trials& trials);

/// One of the reference's lights (its layers) missing, counted twice, of another strength; two missing; the
/// shadows of one missing.
void try_lights(const Evidence& evidence, const image::Image& reference, Trials& trials);

/// A term left out of the reflection equation that the reference has a channel of: V ("visibility.V",
/// shadows) or the cosine ("cosine.cos"), as `steradian render --aov visibility,cosine` writes them.
void try_terms(const Evidence& evidence, const image::Image& reference, Trials& trials);

} // namespace sr::golden
