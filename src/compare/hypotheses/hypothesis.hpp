#pragma once
// Hypotheses: named mistakes, each applied to the reference and judged by how much of the difference is left.
#include "compare/diagnose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace sr::compare {

/// A prediction of a value that it cannot know, such as one from outside the image.
inline constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// Both images' colours as linear light, and the pixels over which hypotheses are judged.
struct DiagnosisInput {
    int width = 0;
    int height = 0;
    std::size_t colors = 0;
    std::vector<float> test; // width * height * colors
    std::vector<float> reference;
    std::vector<bool> known;         // by pixel: compared, so that the reference can be moved from there
    std::vector<std::size_t> fitted; // pixels that factors are fitted to: chosen regardless of the difference
    std::vector<std::size_t> pixels; // pixels to explain; of a large image a sample of at most 2^16
    float floor = 0.0f;              // added to the divisor of relative differences
    float max_value = std::numeric_limits<float>::infinity(); // 1 for code values of a screen
    bool has_noise = false;                                   // known: single values tell little
    bool is_whole = true;                                     // all compared pixels, or only the failing ones
    std::string where;                                        // "everywhere", "in 2.1 % of the pixels (…)"

    float t(std::size_t pixel, std::size_t channel) const { return test[pixel * colors + channel]; }
    float r(std::size_t pixel, std::size_t channel) const { return reference[pixel * colors + channel]; }
    /// The distance of two values, 0..1: relative to the larger, so that neither fireflies nor lamps decide.
    float distance(float a, float b) const {
        return std::min(1.0f, std::abs(a - b) / (std::max(std::abs(a), std::abs(b)) + floor));
    }
    float on_screen(float value) const { return std::min(value, max_value); }
};

/// The share of the difference that is left if `prediction(pixel, channel)` is what the mistake makes of the
/// reference: 0 nothing, 1 all of it.
template<typename Prediction>
double residual(const DiagnosisInput& in, const Prediction& prediction) {
    double before = 0.0, after = 0.0;
    for (const std::size_t i : in.pixels)
        for (std::size_t c = 0; c < in.colors; ++c) {
            const float predicted = prediction(i, c);
            if (std::isnan(predicted)) continue;
            before += static_cast<double>(in.distance(in.t(i, c), in.r(i, c)));
            after += static_cast<double>(in.distance(in.t(i, c), in.on_screen(predicted)));
        }
    return before > 0.0 ? after / before : 1.0;
}

/// A hypothesis that was tried, with its residual.
struct Hypothesis {
    Diagnosis diagnosis;
    int degrees_of_freedom = 0;   // of two that explain as much, the one with fewer is chosen
    bool fits_all_pixels = false; // its numbers are fitted to DiagnosisInput::fitted, not to chosen pixels
};
using Hypotheses = std::vector<Hypothesis>;

// Each function appends a family of hypotheses.

/// The whole test image is black, or of one colour.
void hypotheses_blank(const DiagnosisInput& in, Hypotheses& out);

/// A rectangle of the test is black.
void hypotheses_blank_part(const DiagnosisInput& in, Hypotheses& out);

/// Factors: π, two, 4π, 683, an exposure, one for each channel; a constant added.
void hypotheses_factors(const DiagnosisInput& in, Hypotheses& out);

/// sRGB or a power applied or missing, sRGB applied twice; values clipped, or rounded to few levels.
void hypotheses_curves(const DiagnosisInput& in, Hypotheses& out);

/// Channels in another order.
void hypotheses_channel_orders(const DiagnosisInput& in, Hypotheses& out);

/// The image flipped, turned, transposed; shifted by up to two pixels, or by halves of one; made of blocks.
void hypotheses_geometric(const DiagnosisInput& in, Hypotheses& out);

/// The image turned on its side, with width and height swapped; relative to an image of one colour, the mean.
void hypotheses_turned(const image::Image& test, const image::Image& reference, Hypotheses& out);

/// The image at another size; relative to an image of one colour, the mean.
void hypotheses_resized(const image::Image& test, const image::Image& reference, Hypotheses& out);

/// One of the reference's lights (its layers) missing, counted twice, of another strength; two or all
/// missing; the shadows of one missing.
void hypotheses_lights(const DiagnosisInput& in, const image::Image& reference, Hypotheses& out);

/// A term left out of the reflection equation that the reference has a channel of: V ("visibility.V",
/// shadows) or the cosine ("cosine.cos"), as `steradian render --aov visibility,cosine` writes them.
void hypotheses_terms(const DiagnosisInput& in, const image::Image& reference, Hypotheses& out);

} // namespace sr::compare
