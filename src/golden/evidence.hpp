#pragma once
// What mistakes are tried on: two images as linear light, and the pixels in question.
#include "golden/differences.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sr::golden {

/// What a prediction says of a value that it knows nothing about.
inline constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

/// Both images' colours as linear light, and a selection of pixels; mistakes are judged over these.
struct Evidence {
    int width = 0;
    int height = 0;
    std::size_t colors = 0;
    std::vector<float> test; // width * height * colors
    std::vector<float> reference;
    std::vector<bool> known;         // by pixel: compared, so that the reference can be moved from there
    std::vector<std::size_t> fitted; // where factors are read off: chosen without regard to the difference
    std::vector<std::size_t> pixels; // in question; a sample of at most 2^16 of a larger image's
    float floor = 0.0f;              // differences below it do not count as relative ones
    float most = std::numeric_limits<float>::infinity(); // 1 where a screen ends
    bool is_whole = true;                                // all compared pixels, or only those that fail
    std::string where;                                   // "everywhere", "in 2.1 % of the pixels (…)"

    float t(std::size_t pixel, std::size_t channel) const { return test[pixel * colors + channel]; }
    float r(std::size_t pixel, std::size_t channel) const { return reference[pixel * colors + channel]; }
    /// How far two values lie apart, 0..1: relative to the larger, so that neither fireflies nor lamps
    /// decide.
    float distance(float a, float b) const {
        return std::min(1.0f, std::abs(a - b) / (std::max(std::abs(a), std::abs(b)) + floor));
    }
    float on_screen(float value) const { return std::min(value, most); }
};

/// All compared pixels; if the noise is known (z-scores), those that differ by more than four of its
/// standard errors.
Evidence whole_evidence(const Pair& pair, Encoding encoding, const PixelValues* z);

/// The failing pixels alone, which the error map tells; none if they are too few or too alike to tell one
/// mistake from another, or nearly all.
std::optional<Evidence> failing_evidence(const Evidence& whole, const Pair& pair, const image::Image& error);

/// What is left of the difference if `prediction(pixel, channel)` is what the mistake makes of the reference:
/// 0 nothing, 1 all of it.
template<typename Prediction>
double residual(const Evidence& evidence, const Prediction& prediction) {
    double before = 0.0, after = 0.0;
    for (const std::size_t i : evidence.pixels)
        for (std::size_t c = 0; c < evidence.colors; ++c) {
            const float predicted = prediction(i, c);
            if (std::isnan(predicted)) continue;
            before += static_cast<double>(evidence.distance(evidence.t(i, c), evidence.r(i, c)));
            after += static_cast<double>(evidence.distance(evidence.t(i, c), evidence.on_screen(predicted)));
        }
    return before > 0.0 ? after / before : 1.0;
}

/// The median; 0 of no values.
float median(std::vector<float> values);

} // namespace sr::golden
