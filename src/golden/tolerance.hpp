#pragma once
// Limits that people write: "rel=0.02@99.5%".
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sr::golden {

/// What a limit is set on. The first five hold pixel by pixel, where @QUANTILE says for how many pixels.
enum class Measure { rel, abs, z, flip, hdr_flip, mean_rel, mean_abs, rmse, rel_mse, energy, ssim, density };

/// One limit. `rel=0.02@99.5%`: 99.5 % of the pixels lie within 0.02; `rel=0.02`: all do. Without a quantile
/// `flip` and `hdr_flip` limit the mean. `energy=0.01` limits |Σt/Σr - 1| of each channel; `ssim=0.99` is the
/// smallest SSIM allowed; `z=auto` is the limit that equal images exceed once in a thousand comparisons.
struct Tolerance {
    Measure measure = Measure::rel;
    double limit = 0.0;    // for z: 0 is auto
    double quantile = 1.0; // share of the pixels that must keep the limit
    bool by_pixel = true;  // whether the limit is set on pixels, or on a mean or a sum
    std::string text;      // as written
};

/// @throws Error that names the expression and what may stand there.
Tolerance parsed_tolerance(std::string_view expression);

/// Parses each expression.
std::vector<Tolerance> parsed_tolerances(std::span<const std::string> expressions);

/// "rel", "abs", …
std::string_view name_of(Measure measure);

} // namespace sr::golden
