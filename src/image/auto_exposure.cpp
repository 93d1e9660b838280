#include "core/math.hpp"
#include "image/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace sr::image {
namespace {

/// A histogram of luminance, in steps of an eighth of a stop from 2^-40 to 2^40 cd/m².
class Histogram {
public:
    void count(float log2_luminance) {
        const float bin = (log2_luminance + 40.0f) * bins_per_stop;
        ++bins_[static_cast<std::size_t>(std::clamp(bin, 0.0f, static_cast<float>(bins_.size() - 1)))];
        sum_ += log2_luminance;
        ++total_;
    }

    long long total() const { return total_; }
    double mean() const { return sum_ / static_cast<double>(total_); }

    /// The log2 luminance that a share of the pixels does not exceed.
    double quantile(double share) const {
        const double wanted = share * static_cast<double>(total_);
        long long below = 0;
        std::size_t bin = 0;
        while (bin + 1 < bins_.size() && static_cast<double>(below += bins_[bin]) < wanted) ++bin;
        return (static_cast<double>(bin) + 1.0) / bins_per_stop - 40.0;
    }

private:
    static constexpr float bins_per_stop = 8.0f;

    std::array<long long, 640> bins_{};
    double sum_ = 0.0;
    long long total_ = 0;
};

Histogram luminances_of(const Image& film) {
    Histogram histogram;
    const std::size_t channels = static_cast<std::size_t>(film.channels);
    for (std::size_t i = 0; i + channels <= film.pixels.size(); i += channels) {
        const float* p = &film.pixels[i];
        const float L = channels >= 3 ? luminance(p[0], p[1], p[2]) : p[0];
        const bool is_covered = channels < 4 || p[3] > 0.0f;
        if (is_covered && L > 0.0f && std::isfinite(L)) histogram.count(std::log2(L));
    }
    return histogram;
}

} // namespace

float auto_ev100(const Image& film) {
    constexpr double key = 0.18;          // middle grey
    constexpr double share_below_1 = 0.9; // the share of pixels that is to stay below the tone curve's 1
    const Histogram histogram = luminances_of(film);
    if (histogram.total() == 0) return 0.0f;
    // value = L * exposure_factor(ev100), solved for ev100.
    const double for_average = histogram.mean() - std::log2(1.2 * key);
    const double for_highlights = histogram.quantile(share_below_1) - std::log2(1.2);
    return static_cast<float>(std::max(for_average, for_highlights));
}

} // namespace sr::image
