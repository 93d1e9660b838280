#pragma once
// Tolerances: limits written as text, such as "rel=0.02@99.5%".
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::compare {

/// The quantity that a tolerance limits. The first five are measured at each pixel; @QUANTILE applies to
/// these only.
enum class Measure { rel, abs, z, flip, hdr_flip, mean_rel, mean_abs, rmse, rel_mse, energy, ssim, density };

/// One limit. `rel=0.02@99.5%`: 99.5 % of the pixels are within 0.02; `rel=0.02`: all pixels are;
/// `rel=0.02@edges`: all pixels are but those that an edge explains (edges.hpp). Without a quantile, `flip`
/// and `hdr_flip` limit the mean. `energy=0.01` limits |Σt/Σr - 1| of each channel. `ssim=0.99` is the
/// smallest SSIM allowed. `z=auto` is the limit that equal images exceed once in a thousand comparisons.
struct Tolerance {
    Measure measure = Measure::rel;
    double limit = 0.0;          // for z: 0 is auto
    double quantile = 1.0;       // share of the pixels that must keep the limit
    bool by_pixel = true;        // the limit applies to pixels, not to a mean or a sum
    bool forgives_edges = false; // pixels that an edge explains may exceed the limit
    std::string text;            // as written
};

/// Parses an expression. @throws Error with the expression and the allowed forms.
Tolerance parse_tolerance(std::string_view expression);

/// Parses each expression.
std::vector<Tolerance> parse_tolerances(std::span<const std::string> expressions);

/// "rel", "abs", …
std::string_view name_of(Measure measure);

} // namespace sr::compare
